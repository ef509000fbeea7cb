#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/text_cursor.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace gable {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r' || c == '\v' || c == '\f';
}

bool ends_word(char c) { return is_blank(c) || c == '\n'; }

/// Of a number that no double holds: whether it is too small rather than too large.
bool is_tiny(std::string_view word) {
  const size_t exponent = word.find_first_of("eE");
  if (exponent != std::string_view::npos) return word.substr(exponent + 1).starts_with('-');
  return word.find_first_of("123456789") > word.find('.');
}

}  // namespace

bool parse_number(std::string_view word, double* value) {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
    if (!word.empty() && word.front() == '-') return false;
  }
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, *value);
  if (stop != end || word.empty()) return false;
  if (error == std::errc::result_out_of_range) {
    *value = is_tiny(word) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return error != std::errc::invalid_argument;
}

bool TextCursor::find_word_in_line() {
  while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
  if (position_ == text_.size() || text_[position_] == '\n') return false;
  return comment_ == 0 || text_[position_] != comment_;
}

bool TextCursor::find_word() {
  while (!find_word_in_line()) {
    if (position_ == text_.size()) return false;
    skip_line();
  }
  return true;
}

void TextCursor::skip_line() {
  const size_t end = text_.find('\n', position_);
  position_ = end == std::string_view::npos ? text_.size() : end + 1;
}

std::string_view TextCursor::word() {
  if (!find_word()) return {};
  const size_t begin = position_;
  while (position_ < text_.size() && !ends_word(text_[position_])) ++position_;
  return text_.substr(begin, position_ - begin);
}

double TextCursor::number(const char* what) {
  if (!find_word()) refuse(std::string("the file ends where ") + what + " is due");
  // The common case, a decimal that a separator ends, needs one pass over its characters.
  double value;
  const char* end = text_.data() + text_.size();
  const auto [stop, error] = std::from_chars(text_.data() + position_, end, value);
  if (error == std::errc() && (stop == end || ends_word(*stop))) {
    position_ = stop - text_.data();
    return value;
  }
  const size_t begin = position_;
  const std::string_view text = word();
  if (!parse_number(text, &value)) {
    position_ = begin;
    refuse("\"" + std::string(text.substr(0, 24)) + "\" is no number where " + what + " is due");
  }
  return value;
}

int64_t TextCursor::integer(const char* what) {
  const size_t begin = position_;
  const double value = number(what);
  // Beyond 2^53 a double is no exact count; nothing in a file of that size is read anyway.
  if (!(std::abs(value) <= 9007199254740992.0) || value != std::floor(value)) {
    position_ = begin;
    find_word();
    refuse(std::string(what) + " is no whole number");
  }
  return static_cast<int64_t>(value);
}

void TextCursor::refuse(const std::string& problem) const {
  const auto lines = std::count(text_.begin(), text_.begin() + position_, '\n');
  refuse_scan(path_, "line " + std::to_string(lines + 1) + ": " + problem);
}

}  // namespace gable

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gable {

/// Reads numbers and words from text in memory. White space, commas and semicolons separate them;
/// a line may end with \n or \r\n. What is malformed throws Error (kBadInput) that names the file
/// and the line. Locales do not matter.
class TextCursor {
 public:
  /// `comment`: the character that starts a comment up to the end of its line, or 0 for none. The
  /// text and the path must outlive the cursor.
  TextCursor(std::string_view text, const std::string& path, char comment = 0)
      : text_(text), path_(path), comment_(comment) {}

  /// Moves to the next word, over line ends, and says whether there is one.
  bool find_word();
  /// Moves to the next word of this line and says whether there is one.
  bool find_word_in_line();
  /// Moves behind `num_bytes` more bytes.
  void skip(size_t num_bytes) { position_ += num_bytes; }
  /// Moves behind the end of this line.
  void skip_line();

  /// The next word, over line ends; empty at the end of the text.
  std::string_view word();
  /// The next word, over line ends, as a number; NaN and infinite values are numbers.
  double number(const char* what);
  /// The next word, over line ends, as a whole number; 12.0 is one.
  int64_t integer(const char* what);

  size_t position() const { return position_; }
  size_t bytes_left() const { return text_.size() - position_; }
  std::string_view rest() const { return text_.substr(position_); }
  const std::string& path() const { return path_; }

  /// Throws Error (kBadInput): "PATH: line N: PROBLEM; ...".
  [[noreturn]] void refuse(const std::string& problem) const;

 private:
  std::string_view text_;
  const std::string& path_;
  char comment_;
  size_t position_ = 0;
};

/// A whole word as a number: decimal, with or without sign and exponent, nan, inf. Says whether it
/// is one. Values beyond the range of a double become infinite or zero.
bool parse_number(std::string_view word, double* value);

}  // namespace gable

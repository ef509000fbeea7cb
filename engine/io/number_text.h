#pragma once

#include <charconv>
#include <concepts>
#include <string>

namespace gable {

/// Appends a finite number as the shortest decimal that reads back as the same value; also in JSON.
template <typename T>
requires std::integral<T> || std::floating_point<T>
void append_number(T value, std::string* text) {
  char digits[32];
  text->append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// The same of a list, as "[1,2,3]"; `append(item, text)` writes an item.
template <typename List, typename Append>
void append_list(const List& list, std::string* text, const Append& append) {
  *text += '[';
  bool first = true;
  for (const auto& item : list) {
    if (!first) *text += ',';
    first = false;
    append(item, text);
  }
  *text += ']';
}

template <typename List>
void append_numbers(const List& list, std::string* text) {
  append_list(list, text, [](auto value, std::string* t) { append_number(value, t); });
}

}  // namespace gable

#include "gltf/json_text.h"

#include <array>
#include <charconv>

namespace orbicube::gltf {

void JsonText::separate() {
  if (due_) text_ += ',';
  due_ = true;
}

JsonText& JsonText::open(char bracket) {
  separate();
  text_ += bracket;
  due_ = false;
  return *this;
}

JsonText& JsonText::close(char bracket) {
  text_ += bracket;
  due_ = true;
  return *this;
}

void JsonText::quote(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  text_ += '"';
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      text_ += '\\';
      text_ += c;
    } else if (code < 0x20U) {
      text_ += "\\u00";
      text_ += digits[code >> 4U];
      text_ += digits[code & 0xFU];
    } else {
      text_ += c;
    }
  }
  text_ += '"';
}

JsonText& JsonText::key(std::string_view name) {
  separate();
  quote(name);
  text_ += ':';
  due_ = false;
  return *this;
}

JsonText& JsonText::value(std::uint64_t number) {
  separate();
  text_ += std::to_string(number);
  return *this;
}

JsonText& JsonText::value(double number) {
  separate();
  std::array<char, 32> characters;  // the shortest form of a double has at most 24
  text_.append(characters.data(), std::to_chars(characters.begin(), characters.end(), number).ptr);
  return *this;
}

JsonText& JsonText::value(std::string_view text) {
  separate();
  quote(text);
  return *this;
}

JsonText& JsonText::value(std::span<const double> numbers) {
  begin_array();
  for (const double number : numbers)
    value(number);
  return end_array();
}

JsonText& JsonText::raw(std::string_view json) {
  separate();
  text_ += json;
  return *this;
}

}  // namespace orbicube::gltf

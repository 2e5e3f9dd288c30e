// Builds JSON text: commas, quotes and escapes in one place. Our own, since nlohmann-json's values abort the program or
// leak when an allocation fails in them (3.11.2).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace orbicube::gltf {

class JsonText {
 public:
  JsonText& begin_object() { return open('{'); }
  JsonText& end_object() { return close('}'); }
  JsonText& begin_array() { return open('['); }
  JsonText& end_array() { return close(']'); }
  // The name of the member whose value follows.
  JsonText& key(std::string_view name);

  JsonText& value(std::uint64_t number);
  // The shortest text that stands for exactly this double, which must be finite.
  JsonText& value(double number);
  // UTF-8.
  JsonText& value(std::string_view text);
  // An array of finite numbers.
  JsonText& value(std::span<const double> numbers);
  // Text that is JSON already.
  JsonText& raw(std::string_view json);

  template <class Value>
  JsonText& member(std::string_view name, const Value& content) {
    return key(name).value(content);
  }

  const std::string& text() const { return text_; }

 private:
  JsonText& open(char bracket);
  JsonText& close(char bracket);
  // A comma, where one is due before the next value.
  void separate();
  void quote(std::string_view text);

  std::string text_;
  bool due_ = false;  // a comma, before the next value
};

}  // namespace orbicube::gltf

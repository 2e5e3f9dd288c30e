#include "base/counted.h"

namespace orbicube::base {

std::string counted_text(std::int64_t number, std::string_view one, std::string_view many) {
  std::string text = std::to_string(number);
  text += ' ';
  text += number == 1 ? one : many;
  return text;
}

std::string counted_text(std::int64_t number, std::string_view one) {
  std::string text = counted_text(number, one, one);
  if (number != 1) text += 's';
  return text;
}

}  // namespace orbicube::base

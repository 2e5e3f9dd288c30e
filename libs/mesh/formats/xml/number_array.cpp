#include "mesh/formats/xml/number_array.h"

#include <fast_float/fast_float.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "mesh/files/text_scanner.h"
#include "mesh/formats/xml/xml_scanner.h"

namespace orbicube::mesh {

std::size_t size_of(NumberType type) {
  constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

void ArrayPlace::fail(const char* kind, const std::string& what) const {
  throw base::Error(kind, name + ": " + what);
}

NumberArray NumberArray::of_text(std::string_view text, NumberType type, const ArrayPlace& place,
                                 const base::Host& host) {
  NumberArray result(host.memory);
  const bool real = type == NumberType::float32 || type == NumberType::float64;
  result.type_ = real ? NumberType::float64 : NumberType::int64;
  result.bytes_.reserve(4 * text.size());  // a digit and a blank for eight bytes, at most
  const std::size_t size = text.size();
  std::size_t count = 0;
  for (text = trimmed(text); !text.empty();) {
    if (++count % 4096 == 0) host.report("reading", size - text.size(), size);
    const char *const begin = text.data(), *const end = begin + text.size();
    std::array<std::byte, 8> raw{};
    const char* stop = begin;
    std::errc problem{};
    if (real) {
      double value = 0;
      const auto read = fast_float::from_chars(begin, end, value);
      stop = read.ptr;
      problem = read.ec == std::errc::result_out_of_range ? std::errc() : read.ec;  // an infinity is found later
      raw = std::bit_cast<std::array<std::byte, 8>>(value);
    } else {
      std::int64_t value = 0;
      const auto read = std::from_chars(begin, end, value);
      stop = read.ptr;
      problem = read.ec;
      raw = std::bit_cast<std::array<std::byte, 8>>(value);
    }
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
    if (problem != std::errc() || stop != begin + word.size())
      place.fail("parse", std::string(real ? "a number" : "an integer") + " expected, found " + in_quotes(word));
    result.bytes_.insert(result.bytes_.end(), raw.begin(), raw.end());
    text.remove_prefix(word.size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  }
  return result;
}

NumberArray NumberArray::of_bytes(base::Array<std::byte> bytes, NumberType type, std::endian order,
                                  const ArrayPlace& place) {
  if (bytes.size() % size_of(type) != 0) {
    place.fail("parse",
               std::to_string(bytes.size()) + " bytes of numbers of " + std::to_string(size_of(type)) + " bytes each");
  }
  NumberArray result(bytes.get_allocator().resource());
  result.bytes_ = std::move(bytes);
  result.type_ = type;
  result.swapped_ = order != std::endian::native;
  return result;
}

template <class Number>
Number NumberArray::at(std::size_t i) const {
  std::array<std::byte, sizeof(Number)> raw;
  std::memcpy(raw.data(), bytes_.data() + i * sizeof(Number), sizeof(Number));
  if (swapped_) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

double NumberArray::real(std::size_t i) const {
  if (type_ == NumberType::float32) return static_cast<double>(at<float>(i));
  if (type_ == NumberType::float64) return at<double>(i);
  return static_cast<double>(integer(i));
}

std::int64_t NumberArray::integer(std::size_t i) const {
  switch (type_) {
    case NumberType::int8:
      return at<std::int8_t>(i);
    case NumberType::uint8:
      return at<std::uint8_t>(i);
    case NumberType::int16:
      return at<std::int16_t>(i);
    case NumberType::uint16:
      return at<std::uint16_t>(i);
    case NumberType::int32:
      return at<std::int32_t>(i);
    case NumberType::uint32:
      return at<std::uint32_t>(i);
    case NumberType::int64:
    case NumberType::uint64:
      return at<std::int64_t>(i);
    case NumberType::float32:
    case NumberType::float64:
      break;
  }
  return -1;
}

}  // namespace orbicube::mesh

// Arrays of numbers of XML files: as text, or as bytes of either order.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::mesh {

enum class NumberType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t size_of(NumberType type);

// Names an array in messages, as "the array connectivity of Polys".
struct ArrayPlace {
  std::string name;
  [[noreturn]] void fail(const char* kind, const std::string& what) const;
};

class NumberArray {
 public:
  explicit NumberArray(std::pmr::memory_resource* memory) : bytes_(memory) {}

  // Numbers in text with blanks between them. Throws Error "parse" for what is no number of the type, real or integer,
  // "cancelled".
  static NumberArray of_text(std::string_view text, NumberType type, const ArrayPlace& place, const base::Host& host);
  // Throws Error "parse" where the number of bytes is no multiple of the size of a number.
  static NumberArray of_bytes(base::Array<std::byte> bytes, NumberType type, std::endian order,
                              const ArrayPlace& place);

  std::size_t size() const { return bytes_.size() / size_of(type_); }
  // The number at a place: integers also as real numbers.
  double real(std::size_t i) const;
  // Integers only (is_real); those of 64 bits without a sign that are too large are negative.
  std::int64_t integer(std::size_t i) const;
  bool is_real() const { return type_ == NumberType::float32 || type_ == NumberType::float64; }

 private:
  template <class Number>
  Number at(std::size_t i) const;

  base::Array<std::byte> bytes_;
  NumberType type_ = NumberType::int8;
  bool swapped_ = false;
};

}  // namespace orbicube::mesh

#include "mesh/formats/xml/vtk_xml_data.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/files/base64.h"
#include "mesh/formats/xml/zlib_data.h"

namespace orbicube::mesh {
namespace {

// Bytes one after the other, from base64 or as they are.
class Source {
 public:
  Source(std::string_view text, bool base64, const ArrayPlace& place)
      : base64_(base64), raw_(text), decoder_(text), place_(place) {}

  void read(std::span<std::byte> into) {
    if (base64_) {
      if (!decoder_.read(into)) place_.fail("truncated", "the numbers end before their size, or are no base64");
      return;
    }
    if (into.size() > raw_.size()) place_.fail("truncated", "the file ends before the size of the numbers");
    const auto bytes = std::as_bytes(std::span(raw_.data(), into.size()));
    std::copy(bytes.begin(), bytes.end(), into.begin());
    raw_.remove_prefix(into.size());
  }
  // No more bytes than this are left.
  std::uint64_t max_left() const { return base64_ ? decoder_.max_left() : raw_.size(); }

  // Throws "truncated" unless this many items of a number of bytes can be left.
  void require(std::uint64_t items, std::uint64_t bytes_each, const char* what) const {
    if (items <= max_left() / bytes_each) return;
    place_.fail("truncated", "the file says that it has " + std::to_string(items) + " " + what + ", but no more than " +
                                 std::to_string(max_left()) + " bytes follow");
  }

 private:
  bool base64_;
  std::string_view raw_;
  base::Base64Decoder decoder_;
  const ArrayPlace& place_;
};

std::uint64_t header_number(Source& source, const VtkXmlStorage& storage) {
  std::array<std::byte, 8> raw{};
  const std::span<std::byte> read = std::span(raw).first(storage.header_size);
  source.read(read);
  if (storage.order == std::endian::big) std::reverse(read.begin(), read.end());
  std::uint64_t value = 0;
  for (std::size_t i = storage.header_size; i-- > 0;)
    value = value << 8U | std::to_integer<std::uint64_t>(raw[i]);
  return value;
}

// The number of blocks, the size of each and of the last one (0: as the others), then the compressed size of each.
base::Array<std::byte> read_blocks(Source& source, const VtkXmlStorage& storage, const ArrayPlace& place,
                                   const base::Host& host) {
  const std::uint64_t blocks = header_number(source, storage), size = header_number(source, storage);
  const std::uint64_t last = header_number(source, storage);
  source.require(blocks, storage.header_size, "blocks");
  base::Array<std::byte> result(host.memory);
  if (blocks == 0) return result;
  if (last > size) place.fail("parse", "the last block is larger than the others");
  base::Array<std::uint64_t> compressed(host.memory);
  compressed.reserve(blocks);
  std::uint64_t sum = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    compressed.push_back(header_number(source, storage));
    source.require(compressed.back(), 1, "bytes in a block");
    sum += compressed.back();
  }
  source.require(sum, 1, "bytes in blocks");
  const std::uint64_t most = sum * zlib_max_expansion;
  if ((last == 0 ? size : last) > most || (blocks > 1 && size > 0 && blocks - 1 > most / size)) {
    place.fail("parse", std::to_string(blocks) + " blocks of " + std::to_string(size) + " bytes cannot come from " +
                            std::to_string(sum) + " compressed bytes");
  }
  result.resize(last == 0 ? size * blocks : size * (blocks - 1) + last);
  std::span<std::byte> rest(result);
  base::Array<std::byte> packed(host.memory);
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::size_t wanted = i + 1 == blocks && last != 0 ? last : size;
    packed.resize(compressed[i]);
    source.read(packed);
    inflate_exactly(packed, rest.first(wanted), host);
    rest = rest.subspan(wanted);
  }
  return result;
}

base::Array<std::byte> read_bytes(Source& source, const VtkXmlStorage& storage, const ArrayPlace& place,
                                  const base::Host& host) {
  if (storage.compressed) return read_blocks(source, storage, place, host);
  const std::uint64_t size = header_number(source, storage);
  source.require(size, 1, "bytes");
  base::Array<std::byte> result(host.memory);
  result.resize(size);
  constexpr std::size_t piece = std::size_t{1} << 18U;
  for (std::size_t at = 0; at < size; at += piece) {
    host.report("reading", at, size);
    source.read(std::span(result).subspan(at, std::min<std::size_t>(piece, size - at)));
  }
  return result;
}

}  // namespace

std::optional<NumberType> vtk_xml_type(std::string_view name) {
  constexpr std::array types = {std::pair{"Int8", NumberType::int8},       std::pair{"UInt8", NumberType::uint8},
                                std::pair{"Int16", NumberType::int16},     std::pair{"UInt16", NumberType::uint16},
                                std::pair{"Int32", NumberType::int32},     std::pair{"UInt32", NumberType::uint32},
                                std::pair{"Int64", NumberType::int64},     std::pair{"UInt64", NumberType::uint64},
                                std::pair{"Float32", NumberType::float32}, std::pair{"Float64", NumberType::float64}};
  for (const auto& [word, type] : types) {
    if (name == word) return type;
  }
  return std::nullopt;
}

NumberArray read_vtk_xml_array(const VtkXmlArray& array, const VtkXmlStorage& storage, const ArrayPlace& place,
                               const base::Host& host, std::uint64_t& taken) {
  if (array.form == VtkXmlForm::ascii) return NumberArray::of_text(array.text, array.type, place, host);
  if (array.form == VtkXmlForm::appended && array.offset >= storage.appended.size()) {
    place.fail("index-range", "its offset " + std::to_string(array.offset) + " is behind the " +
                                  std::to_string(storage.appended.size()) + " bytes of AppendedData");
  }
  const bool inside = array.form == VtkXmlForm::binary;
  Source source(inside ? array.text : storage.appended.substr(array.offset), inside || storage.appended_base64, place);
  const std::uint64_t before = source.max_left();
  base::Array<std::byte> bytes = read_bytes(source, storage, place, host);
  // Programs may let a few equal arrays share their place.
  constexpr std::uint64_t most_uses = 4;
  if (!inside) taken += before - source.max_left();
  if (taken / most_uses > storage.appended.size())
    place.fail("parse", "arrays overlap: together they have more than 4 times the bytes of AppendedData");
  return NumberArray::of_bytes(std::move(bytes), array.type, storage.order, place);
}

}  // namespace orbicube::mesh

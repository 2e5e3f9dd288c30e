#include "gltf/json/compressed_view.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "base/counted.h"
#include "base/error.h"

namespace orbicube::gltf {

namespace {

constexpr std::uint64_t max_stride = 256;

[[noreturn]] void fail(JsonValue value, const std::string& what) {
  throw base::Error("parse", value.path() + ' ' + what);
}

template <class Value, std::size_t n>
Value word_of(JsonValue value, const std::array<std::pair<std::string_view, Value>, n>& words) {
  for (const auto& [word, meaning] : words)
    if (value.string() == word) return meaning;
  fail(value, "is none of the words that the extension has");
}

CompressionMode mode_of(JsonValue extension) {
  using enum CompressionMode;
  return word_of(extension.required("mode"),
                 std::array<std::pair<std::string_view, CompressionMode>, 3>{
                     {{"ATTRIBUTES", attributes}, {"TRIANGLES", triangles}, {"INDICES", indices}}});
}

CompressionFilter filter_of(JsonValue extension) {
  using enum CompressionFilter;
  const JsonValue filter = extension.member("filter");
  if (!filter) return none;
  return word_of(
      filter,
      std::array<std::pair<std::string_view, CompressionFilter>, 4>{
          {{"NONE", none}, {"OCTAHEDRAL", octahedral}, {"QUATERNION", quaternion}, {"EXPONENTIAL", exponential}}});
}

bool stride_fits(const Compression& view) {
  if (view.mode != CompressionMode::attributes)
    return view.filter == CompressionFilter::none && (view.stride == 2 || view.stride == 4);
  switch (view.filter) {
    case CompressionFilter::octahedral:
      return view.stride == 4 || view.stride == 8;
    case CompressionFilter::quaternion:
      return view.stride == 8;
    case CompressionFilter::none:
    case CompressionFilter::exponential:
      break;
  }
  return view.stride > 0 && view.stride % 4 == 0;
}

}  // namespace

Compression compression_of(JsonValue extension, std::uint64_t view_length) {
  Compression view{};
  view.buffer = extension.required("buffer").unsigned_integer();
  if (const JsonValue offset = extension.member("byteOffset")) view.byte_offset = offset.unsigned_integer();
  view.byte_length = extension.required("byteLength").unsigned_integer();
  const std::uint64_t stride = extension.required("byteStride").unsigned_integer();
  const std::uint64_t count = extension.required("count").unsigned_integer();
  view.mode = mode_of(extension);
  view.filter = filter_of(extension);
  if (stride > max_stride) fail(extension, "has a byteStride of more than 256");
  view.stride = static_cast<std::size_t>(stride);
  if (!stride_fits(view)) fail(extension, "has a byteStride that its mode and filter do not allow");
  if (view.mode == CompressionMode::triangles && count % 3 != 0) fail(extension, "has triangles without three corners");
  if (view_length % stride != 0 || count != view_length / stride)
    throw base::Error("accessor-range", extension.path() + " has " + base::counted(count, "element") + " of " +
                                            base::counted(stride, "byte") + ", but its buffer view has " +
                                            base::counted(view_length, "byte"));
  if (view_length / max_expansion > view.byte_length)
    throw base::Error("accessor-range",
                      extension.path() + " has " + base::counted(view_length, "byte") +
                          ", more than compressed bytes can hold: " + base::counted(view.byte_length, "byte"));
  view.count = static_cast<std::size_t>(count);
  return view;
}

}  // namespace orbicube::gltf

// The one buffer of a written glTF file: pieces that are handed out in order, and what buffer views and accessors say
// of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <span>
#include <vector>

#include "base/array.h"
#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

class BinaryBuffer {
 public:
  explicit BinaryBuffer(const base::Host& host)
      : host_(host), pieces_(host.memory), floats_(host.memory), short_indices_(host.memory) {}

  // Constants of the specification: bufferView.target (5.11.5), accessor.componentType (5.1.3).
  enum class Target : std::uint64_t { none = 0, vertices = 34962, indices = 34963 };
  enum class Component : std::uint64_t { unsigned_8 = 5121, unsigned_16 = 5123, unsigned_32 = 5125, float_32 = 5126 };

  struct View {
    std::uint64_t offset, length;
    Target target;
  };
  struct Accessor {
    std::uint64_t view;
    Component component;
    bool normalized;
    std::uint64_t count;
    std::size_t components;                 // numbers an element, 1 to 4
    std::vector<double> smallest, largest;  // of each component; empty when they are not given
  };

  // Each adds a view that starts at a multiple of four bytes, and an accessor; answers the accessor's number.
  // Values that are given as spans are not copied and must live until the buffer is written.
  // Floats with `components` an element; with the bounds of each component when they are positions.
  std::uint64_t add_floats(std::span<const float> values, std::size_t components, bool with_bounds,
                           Target target = Target::vertices);
  std::uint64_t add_floats(base::Array<float>&& values, std::size_t components, bool with_bounds,
                           Target target = Target::vertices);
  // Colours: four bytes an element, normalised.
  std::uint64_t add_colors(std::span<const std::uint8_t> values);
  // Indices into `vertex_count` vertices, in 16 bits where those suffice.
  std::uint64_t add_indices(std::span<const mesh::Index> values, std::size_t vertex_count);
  // A view alone; answers its number.
  std::uint64_t add_view(std::span<const std::byte> bytes, Target target);

  std::uint64_t size() const { return size_; }
  const std::vector<View>& views() const { return views_; }
  const std::vector<Accessor>& accessors() const { return accessors_; }

  // Calls sink(bytes) for each piece and the zeros between them, in pieces of a few MiB at most.
  template <class Sink>
  void emit(const Sink& sink) const {
    constexpr std::size_t most_at_once = std::size_t{1} << 22U;
    constexpr std::array<std::byte, 4> zeros{};
    std::uint64_t done = 0;
    for (const std::span<const std::byte> piece : pieces_) {
      for (std::size_t at = 0; at < piece.size(); at += most_at_once) {
        host_.report("writing glTF", done + at, size_);
        sink(piece.subspan(at, std::min(most_at_once, piece.size() - at)));
      }
      sink(std::span(zeros).first((4 - piece.size() % 4) % 4));
      done += piece.size();
    }
    host_.report("writing glTF", size_, size_);
  }

 private:
  std::uint64_t add_accessor(Accessor accessor);

  const base::Host& host_;
  base::Array<std::span<const std::byte>> pieces_;
  // Values made for the buffer. Lists, so that spans of the arrays stay valid.
  std::pmr::list<base::Array<float>> floats_;
  std::pmr::list<base::Array<std::uint16_t>> short_indices_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  std::uint64_t size_ = 0;
};

}  // namespace orbicube::gltf

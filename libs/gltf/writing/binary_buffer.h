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
#include "gltf/json/tiny.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

class BinaryBuffer {
 public:
  explicit BinaryBuffer(const base::Host& host)
      : host_(host), pieces_(host.memory), floats_(host.memory), short_indices_(host.memory), elements_(host.memory) {}

  enum class Target : int {
    none = 0,
    vertices = TINYGLTF_TARGET_ARRAY_BUFFER,
    indices = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER
  };

  // Each adds a view that starts at a multiple of four bytes, and an accessor; returns the accessor's number.
  // Values that are given as spans are not copied and must live until the buffer is written.
  // Floats with `components` an element; with the bounds of each component when they are positions.
  int add_floats(std::span<const float> values, std::size_t components, bool with_bounds,
                 Target target = Target::vertices);
  int add_floats(base::Array<float>&& values, std::size_t components, bool with_bounds,
                 Target target = Target::vertices);
  // Colors: four bytes an element, normalized.
  int add_colors(std::span<const std::uint8_t> values);
  // Indices into `vertex_count` vertices, in 16 bits where those suffice.
  int add_indices(std::span<const mesh::Index> values, std::size_t vertex_count);
  // Elements as they are stored, one behind the other, of the type, component type and bounds of `like`. Those of
  // vertices get padding where they are no multiple of four bytes long.
  int add_elements(base::Array<std::byte>&& elements, const tiny::Accessor& like, Target target);
  // An accessor of views that were added.
  void add_described(const tiny::Accessor& accessor) { accessors_.push_back(accessor); }
  // A view alone; returns its number.
  int add_view(std::span<const std::byte> bytes, Target target, std::size_t stride = 0);

  std::uint64_t size() const { return size_; }
  const std::vector<tiny::BufferView>& views() const { return views_; }
  const std::vector<tiny::Accessor>& accessors() const { return accessors_; }

  // Calls sink(bytes) for each piece and the zeros between them, in pieces of at most a few MiB.
  template <class Sink>
  void emit(const Sink& sink) const {
    constexpr std::size_t max_at_once = std::size_t{1} << 22U;
    constexpr std::array<std::byte, 4> zeros{};
    std::uint64_t done = 0;
    for (const std::span<const std::byte> piece : pieces_) {
      for (std::size_t at = 0; at < piece.size(); at += max_at_once) {
        host_.report("writing glTF", done + at, size_);
        sink(piece.subspan(at, std::min(max_at_once, piece.size() - at)));
      }
      sink(std::span(zeros).first((4 - piece.size() % 4) % 4));
      done += piece.size();
    }
    host_.report("writing glTF", size_, size_);
  }

 private:
  int add_accessor(int view, int component_type, std::size_t components, std::size_t count);

  const base::Host& host_;
  base::Array<std::span<const std::byte>> pieces_;
  // Values made for the buffer. Lists, so that spans of the arrays stay valid.
  std::pmr::list<base::Array<float>> floats_;
  std::pmr::list<base::Array<std::uint16_t>> short_indices_;
  std::pmr::list<base::Array<std::byte>> elements_;
  std::vector<tiny::BufferView> views_;
  std::vector<tiny::Accessor> accessors_;
  std::uint64_t size_ = 0;
};

}  // namespace orbicube::gltf

// The vertices of primitives that are written again: positions and morph targets of the scene, the other attributes of
// the file.
#pragma once

#include <map>
#include <utility>

#include "gltf/kept/kept_corners.h"
#include "gltf/writing/binary_buffer.h"
#include "gltf/writing/write.h"

namespace orbicube::gltf {

class KeptVertexWriter {
 public:
  // All must live until the buffer is written.
  KeptVertexWriter(BinaryBuffer& buffer, const Scene& scene, const PlacedCorners& corners, const base::Host& host)
      : buffer_(buffer), scene_(scene), corners_(corners), host_(host), smooth_(host.memory) {}

  // The primitive with the accessors of its attributes and indices, and what else it had in the file. Throws the kinds
  // of read_elements.
  tiny::Primitive write(const PlacedPrimitive& primitive);

 private:
  // Accessors of positions and of each target, with normals.
  struct Shape {
    int position;
    int normal = -1;
    std::vector<std::map<std::string, int>> targets;
  };

  const tiny::Primitive& source(const PlacedPrimitive& primitive) const;
  const Shape& shape_of(const PlacedPrimitive& primitive);
  base::Array<float> gathered(const PlacedPrimitive& primitive, std::span<const float> of_surface,
                              std::size_t components) const;
  base::Array<float> normals_of(const PlacedPrimitive& primitive);
  base::Array<float> kept_vectors(const PlacedPrimitive& primitive, int accessor, std::size_t components) const;
  int tangents_of(const PlacedPrimitive& primitive, int accessor);
  int blended(const PlacedPrimitive& primitive, int accessor);
  void add_influences(const PlacedPrimitive& primitive, tiny::Primitive& to);
  const base::Array<float>& smooth_normals_of(std::size_t state);

  BinaryBuffer& buffer_;
  const Scene& scene_;
  const PlacedCorners& corners_;
  const base::Host& host_;
  std::map<std::pair<std::size_t, int>, Shape> shapes_;    // by group and accessor of normals
  std::map<std::pair<std::size_t, int>, int> blended_;     // by group and accessor
  std::pmr::map<std::size_t, base::Array<float>> smooth_;  // of the surface, then of each target
};

}  // namespace orbicube::gltf

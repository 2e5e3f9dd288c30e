// Faces of any number of corners, as files have them, and how they become triangles.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

class Polygons {
 public:
  explicit Polygons(std::pmr::memory_resource* memory) : corners_(memory), sizes_(memory) {}

  void reserve_triangles(std::size_t count) { corners_.reserve(3 * count); }
  void add(std::span<const Index> corners);
  void add_triangle(Index a, Index b, Index c) {
    corners_.insert(corners_.end(), {a, b, c});
    if (!sizes_.empty()) sizes_.push_back(3);
  }
  std::size_t size() const { return sizes_.empty() ? corners_.size() / 3 : sizes_.size(); }
  // Faces of more than three corners.
  std::size_t larger_than_triangles() const { return larger_; }

  // Appends the triangles, face after face: a fan from the first corner where all of its triangles agree with the
  // face's normal, and ears clipped (Meisters 1975) from the face seen along its normal where they do not, as on a
  // concave face. Throws Error "degenerate-face" for a larger face with a repeated corner.
  void to_triangles(std::span<const Vector3> positions, Array<Triangle>& triangles, const base::Host& host) const;

 private:
  Array<Index> corners_;
  Array<Index> sizes_;  // empty while all faces are triangles
  std::size_t larger_ = 0;
};

}  // namespace orbicube::mesh

// Faces of any number of corners, as files have them, and how they become triangles.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/counted.h"
#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

class Polygons {
 public:
  explicit Polygons(std::pmr::memory_resource* memory) : corners_(memory), sizes_(memory), sorted_(memory) {}

  void reserve_triangles(std::size_t count) { corners_.reserve(3 * count); }
  // `place.fail(kind, message)` throws Error: "parse" for fewer than three corners, "degenerate-face" for a face of
  // more than three with a corner twice.
  template <class Place>
  void add(std::span<const Index> corners, const Place& place) {
    if (corners.size() < 3) {
      place.fail("parse",
                 "a face with " + base::counted(corners.size(), "vertex", "vertices") + ", where three are the fewest");
    }
    if (const auto repeated = repeated_corner(corners)) {
      place.fail("degenerate-face", "a face of " + base::counted(corners.size(), "corner") + " has one twice: vertex " +
                                        std::to_string(*repeated) + ", counted from 0");
    }
    append(corners);
  }
  void add_triangle(Index a, Index b, Index c) {
    corners_.insert(corners_.end(), {a, b, c});
    if (!sizes_.empty()) sizes_.push_back(3);
  }
  std::size_t size() const { return sizes_.empty() ? corners_.size() / 3 : sizes_.size(); }
  // Faces of more than three corners.
  std::size_t larger_than_triangles() const { return larger_; }
  // Triangles that a face becomes: two fewer than it has corners.
  std::size_t triangles_of(std::size_t face) const { return sizes_.empty() ? 1 : sizes_[face] - 2; }

  // Appends the triangles, face after face: a fan from the first corner where all of its triangles agree with the
  // face's normal, and ears clipped (Meisters 1975) from the face seen along its normal where they do not, as on a
  // concave face. O(n), but O(k^2) for each face of k corners
  // that is no fan. Throws Error "cancelled".
  void to_triangles(std::span<const Vector3> positions, Array<Triangle>& triangles, const base::Host& host) const;

 private:
  // A vertex that is more than one corner of a face of more than three.
  std::optional<Index> repeated_corner(std::span<const Index> corners);
  void append(std::span<const Index> corners);

  Array<Index> corners_;
  Array<Index> sizes_;  // empty while all faces are triangles
  std::size_t larger_ = 0;
  Array<Index> sorted_;  // scratch
};

}  // namespace orbicube::mesh

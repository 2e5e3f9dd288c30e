// What the steps of a repair share: the triangles they change, what is reported of each place, and the options.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/array.h"
#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::repair {

using base::Array;
using mesh::Index;
using mesh::no_index;
using mesh::Triangle;
using mesh::Vector3;

// Triangles of any kind with the place of each vertex and triangle in the input; no_index: made by the repair.
struct Soup {
  explicit Soup(std::pmr::memory_resource* memory)
      : positions(memory), vertex_source(memory), triangles(memory), triangle_source(memory) {}

  Index add_vertex(const Vector3& position, Index source) {
    positions.push_back(position);
    vertex_source.push_back(source);
    return static_cast<Index>(positions.size() - 1);
  }
  void add_triangle(const Triangle& triangle, Index source) {
    triangles.push_back(triangle);
    triangle_source.push_back(source);
  }
  std::pmr::memory_resource* memory() const { return positions.get_allocator().resource(); }

  Array<Vector3> positions;
  Array<Index> vertex_source;
  Array<Triangle> triangles;
  Array<Index> triangle_source;
};

// What was done at one place; the values are those of OBC_REPAIR_... in the C interface.
enum class Action : std::int32_t {
  welded_vertex = 0,     // size: distance from the vertex that it was welded to
  removed_degenerate,    // a face with a repeated corner
  removed_duplicate,     // a face on the corners of another
  collapsed_edge,        // of a near-degenerate triangle; size: length of the edge
  flipped_edge,          // the longest of a near-degenerate triangle; size: height of the triangle
  left_near_degenerate,  // a near-degenerate triangle that stays; size: height
  split_edge,            // T-junction: an edge split at a vertex; size: distance of the vertex from the edge
  split_contact_edge,    // count: faces at the edge; size: length of the edge
  split_contact_vertex,  // count: fans of faces at the vertex
  dropped_part,          // count: triangles; size: area
  filled_hole,           // count: edges of the boundary loop; size: its length
  left_hole,             // the same of one that stays open
  cut_handle,            // count: edges of the loop; size: its length
};

// As "filled-hole"; "unknown" for other numbers.
const char* name_of(Action action);

struct Event {
  Action action;
  Index count;
  Vector3 place;
  double size;
};

// What a step needs besides the triangles.
struct Context {
  const base::Host& host;
  Array<Event>& events;
  Array<std::uint8_t>& counted;  // 0 for triangles of the input that are no surface or were dropped with their part

  void record(Action action, const Vector3& place, double size = 0, std::size_t count = 0) const {
    events.push_back({action, static_cast<Index>(count), place, size});
  }
};

}  // namespace orbicube::repair

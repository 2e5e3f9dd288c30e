#include "repair/labels/simple_voxel.h"

#include <array>
#include <bit>
#include <cstdlib>

namespace orbicube::repair {
namespace {

using Adjacency = std::array<Neighborhood, 27>;

constexpr int center = 13;

constexpr int coordinate(int n, int axis) {
  return axis == 0 ? n % 3 : axis == 1 ? n / 3 % 3 : n / 9;
}

// The number of coordinates in which two neighbors differ; 3 also where a coordinate differs by 2.
constexpr int distance(int a, int b) {
  int differ = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int d = coordinate(a, axis) - coordinate(b, axis);
    if (d > 1 || d < -1) return 4;
    differ += d != 0;
  }
  return differ;
}

constexpr Neighborhood within(int n, int most) {
  Neighborhood bits = 0;
  for (int m = 0; m < 27; ++m) {
    if (m != n && distance(n, m) <= most) bits |= Neighborhood{1} << m;
  }
  return bits;
}

constexpr Adjacency adjacency(int most) {
  Adjacency table{};
  for (int n = 0; n < 27; ++n)
    table[static_cast<std::size_t>(n)] = within(n, most);
  return table;
}

constexpr Adjacency through_faces = adjacency(1), through_corners = adjacency(3);
constexpr Neighborhood faces = within(center, 1), faces_and_edges = within(center, 2), all = within(center, 3);

Neighborhood lowest(Neighborhood bits) {
  return bits & (~bits + 1);
}

// What is connected to the seed in the domain.
Neighborhood connected(Neighborhood seed, Neighborhood domain, const Adjacency& adjacent) {
  Neighborhood reached = seed, front = seed;
  while (front != 0) {
    const auto n = static_cast<std::size_t>(std::countr_zero(front));
    front &= front - 1;
    const Neighborhood fresh = adjacent[n] & domain & ~reached;
    reached |= fresh;
    front |= fresh;
  }
  return reached;
}

}  // namespace

bool is_simple(Neighborhood object) {
  const Neighborhood touching = object & faces, background = ~object & all;
  if (touching == 0 || background == 0) return false;
  if ((touching & ~connected(lowest(touching), object & faces_and_edges, through_faces)) != 0) return false;
  return (background & ~connected(lowest(background), background, through_corners)) == 0;
}

}  // namespace orbicube::repair

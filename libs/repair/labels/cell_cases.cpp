#include "repair/labels/cell_cases.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace orbicube::repair {
namespace {

constexpr std::uint8_t none = 255;

// The number of the edge between two adjacent corners.
std::uint8_t edge_between(int a, int b) {
  return static_cast<std::uint8_t>(3 * std::min(a, b) + std::countr_zero(static_cast<unsigned>(a ^ b)));
}

// The corners of a face in the order that turns counterclockwise seen from outside.
std::array<int, 4> corners_of_face(int axis, int side) {
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
  if (side == 1) return {base, base | u, base | u | v, base | v};
  return {base, base | v, base | u | v, base | u};
}

bool share_a_face(std::uint8_t e, std::uint8_t f) {
  for (int axis = 0; axis < 3; ++axis) {
    if (e % 3 == axis || f % 3 == axis) continue;
    if ((e / 3 >> axis & 1) == (f / 3 >> axis & 1)) return true;
  }
  return false;
}

// next[e]: the edge that follows e in its loop. On each face, each run of corners of the object is cut off by one
// segment.
std::array<std::uint8_t, 24> segments_of(unsigned corners) {
  std::array<std::uint8_t, 24> next{};
  next.fill(none);
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const std::array<int, 4> around = corners_of_face(axis, side);
      for (std::size_t i = 0; i < 4; ++i) {
        const auto in = [&](std::size_t k) { return (corners >> around[k % 4] & 1) != 0; };
        if (in(i) || !in(i + 1)) continue;
        std::size_t last = i + 1;
        while (in(last + 1))
          ++last;
        const std::uint8_t entry = edge_between(around[i], around[(i + 1) % 4]);
        const std::uint8_t exit = edge_between(around[last % 4], around[(last + 1) % 4]);
        next[entry] = exit;
      }
    }
  }
  return next;
}

// Triangulates the corners first..last of a loop, whose side first-last is a diagonal or an edge of it, without
// diagonals in a face.
bool triangulate(CellPatch& patch, std::size_t first, std::size_t last) {
  if (last - first < 2) return true;
  const auto allowed = [&](std::size_t a, std::size_t b) {
    return b - a == 1 || (a == 0 && b + 1 == patch.loop_size) || !share_a_face(patch.loop[a], patch.loop[b]);
  };
  // Apexes in the middle first: fewer narrow fans.
  const std::size_t middle = (first + last) / 2;
  for (std::size_t k = 0; k < 2 * (last - first); ++k) {
    const std::size_t apex = k % 2 == 0 ? middle + k / 2 : middle - std::min(middle, k / 2 + 1);
    if (apex <= first || apex >= last || !allowed(first, apex) || !allowed(apex, last)) continue;
    const std::uint8_t count = patch.triangle_count;
    patch.triangles[patch.triangle_count++] = {patch.loop[first], patch.loop[apex], patch.loop[last]};
    if (triangulate(patch, first, apex) && triangulate(patch, apex, last)) return true;
    patch.triangle_count = count;
  }
  return false;
}

void fill(CellPatch& patch) {
  if (triangulate(patch, 0, patch.loop_size - 1U)) return;
  patch.has_center = true;
  patch.triangle_count = patch.loop_size;
  for (std::size_t i = 0; i < patch.loop_size; ++i)
    patch.triangles[i] = {patch.loop[i], patch.loop[(i + 1U) % patch.loop_size], center_vertex};
}

// All but two opposite corners are in the object: the background is connected through the center of the cell by a tube
// between the loops around both.
void make_tube(CellCase& made) {
  CellPatch &first = made.patches[0], &second = made.patches[1];
  // Opposite edges, which have the same axis, share no face and are no neighbors in the tube.
  const auto at = [](const CellPatch& patch, int axis) {
    return *std::find_if(patch.loop.begin(), patch.loop.begin() + 3, [&](std::uint8_t e) { return e % 3 == axis; });
  };
  const auto side = [&](CellPatch& patch, const CellPatch& other) {
    patch.triangle_count = 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint8_t e = patch.loop[i], f = patch.loop[(i + 1) % 3];
      patch.triangles[i] = {e, f, at(other, 3 - e % 3 - f % 3)};
    }
  };
  side(first, second);
  side(second, first);
}

CellCase make_case(unsigned corners) {
  CellCase made;
  std::array<std::uint8_t, 24> next = segments_of(corners);
  for (std::uint8_t start = 0; start < 24; ++start) {
    if (next[start] == none) continue;
    CellPatch& patch = made.patches[made.patch_count++];
    for (std::uint8_t e = start; next[e] != none;) {
      patch.loop[patch.loop_size++] = e;
      e = std::exchange(next[e], none);
    }
    fill(patch);
  }
  const auto background = static_cast<std::uint8_t>(~corners & 255);
  // Opposite corners have numbers c and 7 - c.
  if (std::popcount(background) == 2 && std::countr_zero(background) < 4 &&
      std::countr_zero(background) == std::countl_zero(background))
    make_tube(made);
  return made;
}

}  // namespace

const CellCase& cell_case(std::uint8_t corners) {
  static const std::array<CellCase, 256> cases = [] {
    std::array<CellCase, 256> all{};
    for (unsigned c = 0; c < 256; ++c)
      all[c] = make_case(c);
    return all;
  }();
  return cases[corners];
}

}  // namespace orbicube::repair

#include "volume_map/frames/frame_cut.h"

#include <algorithm>

#include "mesh/topology/disjoint_sets.h"

namespace orbicube::volume_map {
namespace {

using quaternion::cube_group;
using Connectivity = mesh::TetrahedralConnectivity;

// Frames named alike along a spanning tree of the tetrahedra, found breadth first. Returns which faces are cut.
Array<std::uint8_t> cut_tree(const Connectivity& connectivity, FrameCut& cut, const base::Host& host) {
  const std::size_t count = connectivity.tetrahedra().size();
  const Array<std::uint8_t> matching = frame_field::matchings(connectivity, cut.frames, host);
  Array<std::uint8_t> turn(count, 0, host.memory), seen(count, 0, host.memory);
  Array<std::uint8_t> is_cut(4 * count, 1, host.memory);
  Array<Index> queue(host.memory);
  for (Index root = 0; root < count; ++root) {
    if (seen[root] != 0) continue;
    seen[root] = 1;
    queue.assign(1, root);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      if (i % 4096 == 0) host.report("cut", i, count);
      for (Index face = 4 * queue[i]; face < 4 * queue[i] + 4; ++face) {
        const Index other = connectivity.opposite(face);
        if (other == no_index || seen[other / 4] != 0) continue;
        seen[other / 4] = 1;
        turn[other / 4] = cube_group.product[cube_group.inverse[matching[face]]][turn[queue[i]]];
        is_cut[face] = is_cut[other] = 0;
        queue.push_back(other / 4);
      }
    }
  }
  cut.rotation.resize(4 * count);
  for (Index t = 0; t < count; ++t) {
    cut.frames[t] = quaternion::multiply(cut.frames[t], cube_group.element[turn[t]]);
    for (Index face = 4 * t; face < 4 * t + 4; ++face) {
      const Index other = connectivity.opposite(face);
      if (other == no_index) {
        is_cut[face] = 0;
        continue;
      }
      const std::uint8_t to = cube_group.product[matching[face]][turn[other / 4]];
      cut.rotation[face] = cube_group.product[cube_group.inverse[turn[t]]][to];
    }
  }
  return is_cut;
}

// What a solid is cut by, while it is being cut.
struct Cutting {
  const Connectivity& connectivity;
  const mesh::EdgeRings& rings;
  FrameCut& cut;
  Array<std::uint8_t> is_cut;            // of each face
  Array<std::array<Index, 3>> rings_of;  // of each face: the rings that pass it, in its direction or the other
  Array<Index> cut_faces_of;             // of each ring: how many of its faces are cut

  bool regular(Index ring) const { return ring != no_index && !rings.on_boundary(ring) && cut.singular[ring] == 0; }
};

// On the boundary rings are open: a face that is cut may end there.
void find_rings(Cutting& cutting, const base::Host& host) {
  const Connectivity& connectivity = cutting.connectivity;
  const mesh::EdgeRings& rings = cutting.rings;
  FrameCut& cut = cutting.cut;
  cutting.rings_of.assign(connectivity.face_count(), {no_index, no_index, no_index});
  cutting.cut_faces_of.assign(rings.size(), 0);
  cut.singular.resize(rings.size());
  for (Index ring = 0; ring < rings.size(); ++ring) {
    if (ring % 4096 == 0) host.report("cut", ring, rings.size());
    std::uint8_t passed = 0;
    for (const Index face : rings.faces(ring)) {
      if (connectivity.on_boundary(face)) continue;
      passed = cube_group.product[passed][cut.rotation[face]];
      cutting.cut_faces_of[ring] += cutting.is_cut[face];
      for (const Index side : {face, connectivity.opposite(face)}) {
        auto& list = cutting.rings_of[side];
        *std::find(list.begin(), list.end(), no_index) = ring;
      }
    }
    cut.singular[ring] = !rings.on_boundary(ring) && passed != 0;
  }
}

// Cut faces that are alone around a regular edge need not be cut.
void close_lone_faces(Cutting& cutting) {
  Array<Index>& count = cutting.cut_faces_of;
  Array<Index> queue(count.get_allocator());
  for (Index ring = 0; ring < cutting.rings.size(); ++ring) {
    if (count[ring] == 1 && cutting.regular(ring)) queue.push_back(ring);
  }
  while (!queue.empty()) {
    const Index ring = queue.back();
    queue.pop_back();
    if (count[ring] != 1) continue;
    for (const Index face : cutting.rings.faces(ring)) {
      if (cutting.is_cut[face] == 0) continue;
      cutting.is_cut[face] = cutting.is_cut[cutting.connectivity.opposite(face)] = 0;
      for (const Index other : cutting.rings_of[face]) {
        if (other == no_index) continue;
        if (--count[other] == 1 && cutting.regular(other)) queue.push_back(other);
      }
      break;
    }
  }
}

// The cut face that follows `face` around a regular edge with two cut faces, as seen from the same side of the cut.
Index next_of_sheet(const Cutting& cutting, Index face, Index ring) {
  const Index back = cutting.connectivity.opposite(face);
  // The ring passes this face and another one, which undoes it.
  bool along = false;
  Index other = no_index;
  for (const Index passed : cutting.rings.faces(ring)) {
    if (passed == face)
      along = true;
    else if (passed != back && cutting.is_cut[passed] != 0)
      other = passed;
  }
  return other == no_index || !along ? other : cutting.connectivity.opposite(other);
}

// Faces that follow each other around a regular edge have one gap.
void find_sheets(Cutting& cutting) {
  const Connectivity& connectivity = cutting.connectivity;
  FrameCut& cut = cutting.cut;
  const std::size_t faces = connectivity.face_count();
  cut.sheet.assign(faces, no_index);
  cut.forward.assign(faces, 0);
  Array<Index> stack(cutting.is_cut.get_allocator());
  for (Index first = 0; first < faces; ++first) {
    if (cutting.is_cut[first] == 0 || cut.sheet[first] != no_index) continue;
    const auto sheet = static_cast<Index>(cut.sheet_faces.size());
    cut.sheet_faces.push_back(first);
    const auto take = [&](Index face) {
      const Index back = connectivity.opposite(face);
      if (cut.sheet[face] == no_index) {
        cut.sheet[face] = cut.sheet[back] = sheet;
        cut.forward[face] = 1;
        stack.push_back(face);
      } else if (cut.forward[face] == 0 && (cut.one_sided.empty() || cut.one_sided.back() != sheet)) {
        cut.one_sided.push_back(sheet);
      }
    };
    take(first);
    while (!stack.empty()) {
      const Index face = stack.back();
      stack.pop_back();
      for (const Index ring : cutting.rings_of[face]) {
        if (!cutting.regular(ring) || cutting.cut_faces_of[ring] != 2) continue;
        const Index next = next_of_sheet(cutting, face, ring);
        if (next != no_index) take(next);
      }
    }
  }
}

// Corners that meet across a face that is not cut are one.
void number_copies(const Cutting& cutting, const base::Host& host) {
  const Connectivity& connectivity = cutting.connectivity;
  FrameCut& cut = cutting.cut;
  const std::size_t faces = connectivity.face_count();
  mesh::DisjointSets sets(faces, host.memory);
  for (Index face = 0; face < faces; ++face) {
    const Index other = connectivity.opposite(face);
    if (other == no_index || other < face || cutting.is_cut[face] != 0) continue;
    for (const Index v : connectivity.vertices(face)) {
      sets.unite(4 * (face / 4) + connectivity.corner_of(face / 4, v),
                 4 * (other / 4) + connectivity.corner_of(other / 4, v));
    }
  }
  cut.copies.resize(faces / 4);
  for (Index corner = 0; corner < faces; ++corner) {
    const Index root = sets.find(corner);
    Index& copy = cut.copies[corner / 4][corner % 4];
    if (root == corner) {
      copy = static_cast<Index>(cut.vertex_of_copy.size());
      cut.vertex_of_copy.push_back(connectivity.tetrahedra()[corner / 4][corner % 4]);
    } else {
      copy = cut.copies[root / 4][root % 4];
    }
  }
}

}  // namespace

FrameCut cut_open(const Connectivity& connectivity, const mesh::EdgeRings& rings, std::span<const Quaternion> frames,
                  const base::Host& host) {
  FrameCut cut(host.memory);
  cut.frames.assign(frames.begin(), frames.end());
  Cutting cutting{connectivity,
                  rings,
                  cut,
                  cut_tree(connectivity, cut, host),
                  Array<std::array<Index, 3>>(host.memory),
                  Array<Index>(host.memory)};
  find_rings(cutting, host);
  close_lone_faces(cutting);
  find_sheets(cutting);
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    if (cutting.is_cut[face] == 0) cut.rotation[face] = 0;
  }
  number_copies(cutting, host);
  return cut;
}

}  // namespace orbicube::volume_map

#include "polycube/labels/arc_network.h"

#include <Eigen/Geometry>

namespace orbicube::polycube {

ArcNetwork::ArcNetwork(const Surface& surface, const Patches& patches, const base::Host& host)
    : arcs(host.memory),
      half_edges(host.memory),
      arc_of(3 * surface.triangles.size(), no_index, host.memory),
      corners(host.memory),
      corner_of_vertex(surface.positions.size(), no_index, host.memory) {
  const auto label = [&](Index patch) { return patches.labels[patch]; };
  for (std::size_t l = 0; l < patches.loop_count(); ++l) {
    const auto loop = patches.loop(l);
    std::size_t offset = 0;  // of a half-edge that starts at a corner
    while (offset < loop.size() && !patches.is_corner(surface.start(loop[offset])))
      ++offset;
    if (offset == loop.size()) offset = 0;
    for (std::size_t i = 0; i < loop.size();) {
      Index h = loop[(offset + i) % loop.size()];
      if (arc_of[h] != no_index) {
        ++i;
        continue;
      }
      Arc arc{};
      arc.left = patches.patch[h / 3];
      arc.right = patches.patch[surface.neighbor(h)];
      arc.first = surface.start(h);
      arc.begin = static_cast<Index>(half_edges.size());
      do {
        h = loop[(offset + i) % loop.size()];
        half_edges.push_back(h);
        arc_of[h] = arc_of[surface.opposite(h)] = static_cast<Index>(arcs.size());
        arc.length += surface.length(h);
        arc.last = surface.end(h);
        ++i;
      } while (i < loop.size() && !patches.is_corner(arc.last));
      arc.size = static_cast<Index>(half_edges.size()) - arc.begin;
      arc.axis = third_axis(axis_of(label(arc.left)), axis_of(label(arc.right)));
      const Vector3 outward = Vector3::Unit(arc.axis).cross(direction_of(label(arc.left)));
      arc.direction_if_convex = outward.dot(direction_of(label(arc.right))) > 0 ? 1 : -1;
      arcs.push_back(arc);
    }
  }
  for (Index v = 0; v < surface.positions.size(); ++v) {
    if (patches.valence[v] != 3) continue;
    Corner corner{v, {}, {}, 0};
    std::size_t found = 0;
    surface.connectivity.for_each_outgoing(v, [&](Index h) {
      if (arc_of[h] == no_index) return;
      corner.patch[(found + 1) % 3] = patches.patch[h / 3];
      corner.arc[found++] = arc_of[h];
    });
    const Vector3 a = direction_of(label(corner.patch[0]));
    const Vector3 b = direction_of(label(corner.patch[1]));
    const Vector3 c = direction_of(label(corner.patch[2]));
    corner.chirality = a.cross(b).dot(c) > 0 ? 1 : -1;
    corner_of_vertex[v] = static_cast<Index>(corners.size());
    corners.push_back(corner);
  }
}

}  // namespace orbicube::polycube

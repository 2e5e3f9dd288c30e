#include "polycube/layout/layout_drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

#include "base/error.h"
#include "base/heap.h"

namespace orbicube::polycube {
namespace {

// What a turned normal counts for when a node looks for its vertex, in parts of the diagonal, and a node beside it.
constexpr double normal_weight = 0.12, crowding = 0.03;
constexpr std::size_t vertices_a_node = 12;
// How many times its faces a surface may have in the end; a tenth more than it has serves as a rule. One with few faces
// may have more of them, but not any number: paths without room wind around one another, and each makes the surface
// grow by a part of what it is, so that searches in it would soon take minutes.
constexpr std::size_t max_refinement = 24, small_surface = 40'000;

}  // namespace

LayoutDrawing::LayoutDrawing(const Layout& layout, EditableSurface& surface, const base::Host& host)
    : layout_(layout),
      surface_(surface),
      host_(host),
      drawing_(host.memory),
      level_(surface.vertices(), 0, host.memory),
      drawn_(layout.arcs(), 0, host.memory) {
  Vector3 low = surface.position[surface.triangle[0][0]], high = low;
  for (const Triangle& t : surface.triangle) {
    for (const Index v : t) {
      low = low.cwiseMin(surface.position[v]);
      high = high.cwiseMax(surface.position[v]);
    }
  }
  diagonal_ = (high - low).norm();
  max_faces_ = max_refinement * surface.faces();
  drawing_.path.resize(layout.arcs());
}

Index LayoutDrawing::split_edge(Index h) {
  const Index a = surface_.start(h), b = surface_.end(h);
  if (surface_.faces() > max_faces_)
    throw base::Error("no-valid-result", "drawing the polycube's edges would refine the surface beyond measure");
  const Index m = surface_.split_edge(h, 0.5);
  level_.push_back(static_cast<std::uint8_t>(std::min(250, std::max(level_[a], level_[b]) + 1)));
  return m;
}

void LayoutDrawing::refine_for_nodes() {
  const std::size_t wanted = vertices_a_node * layout_.nodes.size();
  const std::size_t faces = 2 * wanted;  // of a closed surface with that number of vertices
  if (faces > std::max(max_faces_, small_surface / 4))
    throw base::Error("no-valid-result", "the surface has too few triangles for a polycube with " +
                                             std::to_string(layout_.nodes.size()) + " corners and ends of cuts");
  max_faces_ = std::max(max_faces_, std::min(2 * max_refinement * faces, small_surface));
  std::size_t used = 0;
  for (Index v = 0; v < surface_.vertices(); ++v)
    used += surface_.outgoing(v) != no_index;
  if (used >= wanted) return;
  base::Heap<std::pair<double, Index>, std::less<>> queue(host_.memory);
  const auto push = [&](Index h) { queue.push({surface_.length(h), h}); };
  for (Index h = 0; h < 3 * surface_.faces(); ++h)
    if (h < surface_.opposite(h)) push(h);
  while (used < wanted) {
    const auto [length, h] = queue.pop();
    if (surface_.length(h) != length) {
      push(h);
      continue;
    }
    const Index m = split_edge(h);
    level_.back() = 0;
    ++used;
    surface_.for_each_outgoing(m, push);
  }
}

Array<Vector3> LayoutDrawing::vertex_normals() const {
  const auto& positions = surface_.position;
  Array<Vector3> normals(positions.size(), Vector3::Zero(), host_.memory);
  for (const Triangle& t : surface_.triangle) {
    const Vector3 normal = (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
    for (const Index v : t)
      normals[v] += normal;
  }
  for (Vector3& normal : normals)
    normal.normalize();
  return normals;
}

// Returns no_index where all vertices are occupied.
Index LayoutDrawing::nearest_free_vertex(const LayoutGuide& guide, Index node, std::span<const Vector3> normals,
                                         std::span<const std::uint8_t> crowded) const {
  const auto& positions = surface_.position;
  const Vector3& wanted = guide.node_position[node];
  double least = std::numeric_limits<double>::infinity();
  Index chosen = no_index;
  for (Index v = 0; v < positions.size(); ++v) {
    if (surface_.occupied[v] || surface_.outgoing(v) == no_index) continue;
    const double cost = (positions[v] - wanted).norm() / diagonal_ +
                        normal_weight * (1 - normals[v].dot(guide.node_normal[node])) + (crowded[v] ? crowding : 0);
    if (cost < least) {
      least = cost;
      chosen = v;
    }
  }
  return chosen;
}

void LayoutDrawing::place_nodes(const LayoutGuide& guide) {
  const Array<Vector3> normals = vertex_normals();
  Array<std::uint8_t> crowded(normals.size(), 0, host_.memory);
  Array<Index> order(layout_.nodes.size(), host_.memory);
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_partition(order.begin(), order.end(), [&](Index n) { return layout_.nodes[n].corner; });
  std::stable_partition(order.begin(), order.end(), [&](Index n) { return guide.node_vertex[n] != no_index; });
  drawing_.node_vertex.assign(order.size(), no_index);
  for (const Index n : order) {
    host_.report("tracing", 0, 0);
    Index chosen = guide.node_vertex[n];
    if (chosen != no_index && surface_.occupied[chosen])
      throw base::Error("no-valid-result", "two corners of the polycube are to be at one vertex");
    if (chosen == no_index) chosen = nearest_free_vertex(guide, n, normals, crowded);
    // Where positions are too degenerate for a distance.
    if (chosen == no_index)
      throw base::Error("no-valid-result", "a corner of the polycube or an end of a cut has no free vertex near it");
    drawing_.node_vertex[n] = chosen;
    surface_.occupied[chosen] = 1;
    surface_.for_each_outgoing(chosen, [&](Index h) { crowded[surface_.end(h)] = 1; });
  }
  unblock(drawing_.node_vertex);
}

void LayoutDrawing::draw(Index arc) {
  mark(arc, drawing_.path[arc], true);
  drawn_[arc] = 1;
  ++drawn_count_;
  unblock(drawing_.path[arc]);
}

void LayoutDrawing::mark(Index arc, std::span<const Index> path, bool on) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    surface_.draw(surface_.between(path[i], path[i + 1]), on ? arc : no_index);
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
    surface_.occupied[path[i]] = on;
}

void LayoutDrawing::unblock(std::span<const Index> vertices) {
  for (const Index v : vertices) {
    for (bool changed = true; changed;) {
      changed = false;
      Index edge = no_index, face = no_index;
      surface_.for_each_outgoing(v, [&](Index h) {
        const Index on = surface_.arc[h];
        if (edge == no_index && on == no_index && surface_.occupied[surface_.end(h)]) edge = h;
        const Index f = h / 3;
        if (surface_.arc[3 * f] != no_index && surface_.arc[3 * f + 1] != no_index &&
            surface_.arc[3 * f + 2] != no_index)
          face = f;
      });
      if (edge != no_index) {
        split_edge(edge);
        changed = true;
      } else if (face != no_index) {
        surface_.split_face(face);
        level_.push_back(1);
        changed = true;
      }
    }
  }
}

void LayoutDrawing::sector(Index dart, Array<Index>& half_edges) const {
  const Index node = layout_.origin(dart), vertex = drawing_.node_vertex[node];
  const auto around = layout_.darts_of(node);
  const auto place = static_cast<std::size_t>(std::find(around.begin(), around.end(), dart) - around.begin());
  half_edges.clear();
  for (std::size_t back = 1; back < around.size(); ++back) {
    const Index before = around[(place + around.size() - back) % around.size()];
    if (!drawn_[before / 2]) continue;
    const auto& path = drawing_.path[before / 2];
    const Index second = before % 2 == 0 ? path[1] : path[path.size() - 2];
    for (Index h = surface_.turned(surface_.between(vertex, second)); surface_.arc[h] == no_index;
         h = surface_.turned(h))
      half_edges.push_back(h);
    return;
  }
  surface_.for_each_outgoing(vertex, [&](Index h) {
    if (surface_.arc[h] == no_index) half_edges.push_back(h);
  });
}

bool LayoutDrawing::sides_connected(std::span<const Index> path) const {
  const Index h = surface_.between(path[0], path[1]);
  const Index goal = surface_.opposite(h) / 3;
  Array<std::uint8_t> seen(surface_.faces(), 0, host_.memory);
  Array<Index> waiting(1, h / 3, host_.memory);
  seen[h / 3] = 1;
  while (!waiting.empty()) {
    const Index f = waiting.back();
    waiting.pop_back();
    if (f == goal) return true;
    for (Index k = 0; k < 3; ++k) {
      const Index across = surface_.opposite(3 * f + k) / 3;
      if (surface_.arc[3 * f + k] != no_index || seen[across]) continue;
      seen[across] = 1;
      waiting.push_back(across);
    }
  }
  return false;
}

}  // namespace orbicube::polycube

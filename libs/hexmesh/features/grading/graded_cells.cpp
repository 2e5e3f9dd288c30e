#include "hexmesh/features/grading/graded_cells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hexmesh/features/pillowing.h"
#include "hexmesh/grid/voxel_hexes.h"
#include "mesh/search/measures.h"

namespace orbicube::hexmesh {
namespace {

// Edges of the surface bend by at most this many cells from the line between the ends.
constexpr double max_bend = 0.2;

SplitSurface split_where_bent(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                              const mesh::FeatureGraph& graph, const AxisGrading& grading, const base::Host& host) {
  SplitSurface surface(positions, triangles, graph, host.memory);
  split_edges(
      surface,
      [&](const Vector3& from, const Vector3& to) {
        const Vector3 middle = 0.5 * (grading.cells(from) + grading.cells(to));
        return (grading.cells(0.5 * (from + to)) - middle).squaredNorm() > max_bend * max_bend;
      },
      host);
  return surface;
}

// Gives the quads around the inner vertices of a path, on its left, the number of a layer.
void put_left_of(std::span<const Index> path, const BoundaryQuads& quads, Index layer, Array<Index>& layer_of_quad) {
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Index last = quads.find(path[i], path[i - 1]);
    for (Index h = quads.find(path[i], path[i + 1]); h != last; h = quads.turned(h))
      layer_of_quad[h / 4] = layer;
  }
}

}  // namespace

GradedSurface::GradedSurface(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                             const mesh::FeatureGraph& graph, const AxisGrading& given, const base::Host& host)
    : grading(given), in_space(split_where_bent(positions, triangles, graph, given, host)), cells(host.memory) {
  for (const Vector3& p : in_space.positions)
    cells.push_back(grading.cells(p));
  volume = mesh::measures(cells, in_space.triangles, host).volume;
}

GradedCells::GradedCells(const GradedSurface& surface, const base::Host& host)
    : host_(host), surface_(surface), mesh_(host.memory), embedding_(host.memory), sizes_(host.memory) {
  const auto& [positions, triangles, graph] = surface.in_space;
  VoxelHexes grid =
      voxel_hexahedra(surface.cells, triangles, static_cast<std::size_t>(std::lround(surface.volume)), host);
  mesh_ = std::move(grid.mesh);
  scale_ = grid.scale;
  in_cells_.emplace(surface.cells, triangles, graph, scale_, host);
}

Array<FeatureObstacle> GradedCells::embed() {
  constexpr int max_choices = 8;  // of ends of arcs, around those that were shut in before
  BoundaryQuads quads(mesh_.hexahedra, mesh_.positions.size(), host_);
  const auto only = [&](std::optional<FeatureObstacle> obstacle) {
    Array<FeatureObstacle> obstacles(host_.memory);
    if (obstacle) obstacles.push_back(std::move(*obstacle));
    return obstacles;
  };
  if (auto obstacle = place_corners(mesh_, quads, *in_cells_, embedding_, host_)) return only(std::move(obstacle));
  Array<FeatureObstacle> obstacles(host_.memory);
  int choices = 0;
  for (const double price : {3.0, 1.0, 0.3}) {
    Routing routing(host_.memory);
    do {
      if (choices == 0 || routing.choose_again) {
        if (choices++ == max_choices) break;
        if (auto obstacle = choose_arc_ends(mesh_, quads, *in_cells_, embedding_, host_))
          return only(std::move(obstacle));
      }
      routing = route_arcs(mesh_, quads, *in_cells_, price, embedding_, host_);
    } while (routing.choose_again && routing.obstacles.empty());
    obstacles = std::move(routing.obstacles);
    if (routing.choose_again && obstacles.empty())
      return only(FeatureObstacle{no_index, no_index, "arcs shut in others, wherever they begin"});
    if (obstacles.empty()) obstacles = only(match_patches(mesh_, quads, *in_cells_, embedding_, host_));
    if (obstacles.empty()) return only(add_rings(quads));
  }
  return obstacles;
}

// A layer on each patch, closed along its border: arcs get two quads a side at their corners, whatever their paths.
// An arc with one patch on both sides gets a layer of its own on the quads at its left.
std::optional<FeatureObstacle> GradedCells::add_rings(const BoundaryQuads& quads) {
  Array<Index> layer_of_quad(embedding_.quad_patches, host_.memory), patch_of_layer(host_.memory);
  for (Index p = 0; p < in_cells_->patches(); ++p)
    patch_of_layer.push_back(p);
  for (Index a = 0; a < in_cells_->arcs(); ++a) {
    const auto& [left, right] = in_cells_->graph().arcs[a].patches;
    if (left != right) continue;
    put_left_of(embedding_.paths[a], quads, static_cast<Index>(patch_of_layer.size()), layer_of_quad);
    patch_of_layer.push_back(left);
  }
  Array<Index> labels(mesh_.hexahedra.size(), 0, host_.memory);
  for (Index q = 0; q < quads.quads().size(); ++q) {
    Index& label = labels[quads.owner(q)];
    const Index own = layer_of_quad[q] + 1;
    if (label != 0 && label != own) return FeatureObstacle{no_index, no_index, "a hexahedron is on two patches"};
    label = own;
  }
  pillow(mesh_, labels, host_);
  const BoundaryQuads outer(mesh_.hexahedra, mesh_.positions.size(), host_);
  mesh_.quads.assign(outer.quads().begin(), outer.quads().end());
  mesh_.quad_patches.clear();
  for (Index q = 0; q < mesh_.quads.size(); ++q)
    mesh_.quad_patches.push_back(patch_of_layer[labels[outer.owner(q)] - 1]);
  return {};
}

// Cubes of the grid are boxes in space.
void GradedCells::move_to_space() {
  const AxisGrading& grading = surface_.grading;
  unit_ = scale_ / grading.base_size();
  targets_.emplace(mesh_, *in_cells_, embedding_, host_);
  const auto part_of_base = [&](const Vector3& in_space) {
    return Vector3(grading.size(in_space) / grading.base_size());
  };
  const auto position = [&](const Vector3& in_cells) { return grading.position(in_cells / scale_); };
  sizes_.clear();
  for (const Hexahedron& h : mesh_.hexahedra) {
    Vector3 center = Vector3::Zero();
    for (const Index v : h)
      center += mesh_.positions[v] / 8;
    const Vector3 part = part_of_base(position(center));
    std::array<double, 3>& size = sizes_.emplace_back();
    for (std::size_t d = 0; d < 3; ++d) {
      Vector3 along = Vector3::Zero();
      for (const auto& e : edges_along[d])
        along += mesh_.positions[h[e[1]]] - mesh_.positions[h[e[0]]];
      size[d] = along.stableNormalized().cwiseProduct(part).norm();
      if (!(size[d] > 0)) size[d] = std::cbrt(part.prod());
    }
  }
  Array<double> at_vertices(mesh_.positions.size(), 1, host_.memory);
  for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
    const Vector3 p = position(mesh_.positions[v]);
    at_vertices[v] = std::cbrt(part_of_base(p).prod());
    mesh_.positions[v] = unit_ * p;
  }
  const auto& [positions, triangles, graph] = surface_.in_space;
  in_space_.emplace(positions, triangles, graph, unit_, host_);
  targets_->move_to(*in_space_, at_vertices);
}

}  // namespace orbicube::hexmesh

#include "polycube/layout/drawn_construction.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "base/error.h"
#include "mesh/search/bounding_volume_tree.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/topology.h"
#include "polycube/layout/layout_guide.h"
#include "polycube/layout/layout_map.h"
#include "polycube/outputs/inverse_map.h"
#include "polycube/unfolded/map_improvement.h"

namespace orbicube::polycube {
namespace {

mesh::Box box_of(std::span<const Vector3> points) {
  mesh::Box box;
  for (const Vector3& p : points)
    box.add(p);
  return box;
}

mesh::Box box_of(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  mesh::Box box;
  for (const Triangle& t : triangles)
    for (const Index v : t)
      box.add(positions[v]);
  return box;
}

// Points with normals, moved together.
struct OrientedPoints {
  explicit OrientedPoints(std::pmr::memory_resource* memory) : positions(memory), normals(memory) {}

  void add(const Vector3& position, const Vector3& normal) {
    positions.push_back(position);
    normals.push_back(normal);
  }
  // Each axis of one box to that of another; a flat axis is moved only.
  void stretch(const mesh::Box& from, const mesh::Box& to) {
    Vector3 scale = Vector3::Ones();
    for (Eigen::Index a = 0; a < 3; ++a)
      if (from.high[a] > from.low[a] && to.high[a] > to.low[a])
        scale[a] = (to.high[a] - to.low[a]) / (from.high[a] - from.low[a]);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      positions[i] = 0.5 * (to.low + to.high) + scale.cwiseProduct(positions[i] - 0.5 * (from.low + from.high));
      normals[i] = normals[i].cwiseQuotient(scale).normalized();
    }
  }
  void bend(const ScatteredMap& map) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Eigen::Matrix3d derivative = map.derivative(positions[i]);
      positions[i] = map(positions[i]);
      // Where space is flipped the map has nothing to say about sides.
      if (!(derivative.determinant() > 0)) continue;
      const Vector3 normal = derivative.inverse().transpose() * normals[i];
      if (normal.allFinite() && normal.norm() > 0) normals[i] = normal.normalized();
    }
  }

  Array<Vector3> positions, normals;
};

class DrawnConstruction {
 public:
  DrawnConstruction(std::span<const Vector3> positions, std::span<const Triangle> triangles, const PatchGraph& target,
                    const DrawingOptions& options, const base::Host& host)
      : positions_(positions),
        triangles_(triangles),
        target_(target),
        options_(options),
        host_(host),
        layout_(make_layout(solid_of(target, host), host)),
        surface_(positions, triangles, host),
        guide_(host.memory) {}

  Construction run() {
    check_places();
    make_guide();
    place_corners();
    Construction made(host_.memory);
    Drawing drawing = trace(layout_, guide_, surface_, host_);
    made.tried = 1;
    made.map = map_layout(layout_, surface_, drawing, {}, host_);
    made.certificate = certify(made.map, host_);
    if (!made.certificate.valid()) throw base::Error("no-valid-result", made.certificate.reason);
    made.distortion = measure_distortion(made.map, host_);
    made.valid = 1;
    return made;
  }

 private:
  void check_places() {
    Array<std::uint8_t> corner_seen(target_.corners.size(), 0, host_.memory);
    Array<std::uint8_t> vertex_seen(positions_.size(), 0, host_.memory);
    for (const CornerPlace& place : options_.places) {
      base::require(place.corner < target_.corners.size(), "the polycube has no such corner");
      base::require(!corner_seen[place.corner], "a corner of the polycube has two places");
      corner_seen[place.corner] = 1;
      base::require(place.point.allFinite(), "the place of a corner is not finite");
      if (place.vertex == no_index) continue;
      base::require(place.vertex < positions_.size() && surface_.outgoing(place.vertex) != no_index,
                    "the surface has no such vertex");
      base::require(!vertex_seen[place.vertex], "a vertex is the place of two corners");
      vertex_seen[place.vertex] = 1;
    }
    base::require(options_.pose.empty() || options_.pose.size() == target_.corners.size(),
                  "the pose must have a point for each corner");
  }

  Vector3 point_of(const CornerPlace& place) const {
    return place.vertex != no_index ? positions_[place.vertex] : place.point;
  }

  // Points of the polycube, as many a node and an arc as this.
  static constexpr std::size_t pieces_of_arc = 8;

  void make_guide() {
    OrientedPoints points(host_.memory);
    for (Index n = 0; n < layout_.nodes.size(); ++n)
      points.add(layout_.node_position(n), layout_.nodes[n].normal);
    for (Index a = 0; a < layout_.arcs(); ++a) {
      const Vector3 from = layout_.node_position(layout_.origin(2 * a)),
                    to = layout_.node_position(layout_.target(2 * a));
      const auto axis = static_cast<Eigen::Index>(layout_.axis(a));
      for (std::size_t i = 0; i <= pieces_of_arc; ++i) {
        Vector3 p = from;
        if (i == pieces_of_arc) p = to;
        const double part = static_cast<double>(i) / pieces_of_arc;
        if (i > 0 && i < pieces_of_arc) p[axis] = from[axis] + part * (to[axis] - from[axis]);
        points.add(p, Vector3::UnitZ());
      }
    }
    // Corners move along, to be compared with their target positions.
    for (const CornerPlace& place : options_.places)
      points.add(target_.corners[place.corner], Vector3::UnitZ());
    const mesh::Box here = box_of(positions_, triangles_);
    if (options_.model != nullptr) {
      follow_model(points);
      if (options_.from_model != nullptr)
        points.bend(*options_.from_model);
      else
        points.stretch(box_of(options_.model->positions, options_.model->triangles), here);
    } else {
      if (!options_.pose.empty()) points.bend(ScatteredMap(target_.corners, options_.pose, 0, host_));
      const std::size_t own = points.positions.size() - options_.places.size();
      points.stretch(box_of(std::span(points.positions).first(own)), here);
    }
    if (!options_.places.empty()) {
      Array<Vector3> wanted(host_.memory);
      for (const CornerPlace& place : options_.places)
        wanted.push_back(point_of(place));
      const std::size_t own = points.positions.size() - wanted.size();
      points.bend(ScatteredMap(std::span(points.positions).subspan(own), wanted, 0, host_));
    }
    for (Index n = 0; n < layout_.nodes.size(); ++n) {
      guide_.node_position.push_back(points.positions[n]);
      guide_.node_normal.push_back(points.normals[n]);
    }
    guide_.node_vertex.assign(layout_.nodes.size(), no_index);
    for (std::size_t a = 0, at = layout_.nodes.size(); a < layout_.arcs(); ++a) {
      Array<Vector3>& line = guide_.arc.emplace_back();
      for (std::size_t i = 0; i <= pieces_of_arc; ++i)
        line.push_back(points.positions[at++]);
    }
  }

  // From the polycube to the surface of the model.
  void follow_model(OrientedPoints& points) const {
    const SurfaceMap& model = *options_.model;
    const LocatedPoints located = locate(model, points.positions, host_);
    Array<Vector3> normals(model.positions.size(), Vector3::Zero(), host_.memory);
    for (const Triangle& t : model.triangles) {
      const Vector3 normal =
          (model.positions[t[1]] - model.positions[t[0]]).cross(model.positions[t[2]] - model.positions[t[0]]);
      for (const Index v : t)
        normals[v] += normal;
    }
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
      if (located.triangles[i] == no_index) throw base::Error("invalid-argument", "the model's polycube is another");
      const Triangle& t = model.triangles[located.triangles[i]];
      points.positions[i] = interpolate(model, located.triangles[i], located.weights[i]);
      Vector3 normal = Vector3::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        normal += located.weights[i][static_cast<Eigen::Index>(k)] * normals[t[k]].normalized();
      if (normal.norm() > 0) points.normals[i] = normal.normalized();
    }
  }

  // A vertex at a place on the surface, a new one unless there is one very near.
  Index vertex_at(const mesh::SurfacePoint& wanted) {
    // The part of the input's triangle that has the point, after splits for others.
    double least = std::numeric_limits<double>::infinity();
    Index face = no_index;
    mesh::TrianglePoint at{};
    for (Index f = 0; f < surface_.faces(); ++f) {
      if (surface_.triangle_source[f] != wanted.triangle) continue;
      const Triangle& t = surface_.triangle[f];
      const mesh::TrianglePoint here = mesh::nearest_on_triangle(wanted.position, surface_.position[t[0]],
                                                                 surface_.position[t[1]], surface_.position[t[2]]);
      if (const double distance = (here.position - wanted.position).norm(); distance < least) {
        least = distance;
        face = f;
        at = here;
      }
    }
    constexpr double near = 1e-3;
    Eigen::Index most = 0, fewest = 0;
    at.weights.maxCoeff(&most);
    at.weights.minCoeff(&fewest);
    const auto corner = [&](Eigen::Index k) { return surface_.triangle[face][static_cast<std::size_t>(k)]; };
    if (at.weights[most] > 1 - near) return corner(most);
    if (at.weights[fewest] < near) {
      const Eigen::Index from = (fewest + 1) % 3;
      const double part = at.weights[(fewest + 2) % 3] / (at.weights[from] + at.weights[(fewest + 2) % 3]);
      return surface_.split_edge(surface_.between(corner(from), corner((fewest + 2) % 3)), part);
    }
    const Triangle t = surface_.triangle[face];
    const Index m = surface_.split_face(face);
    surface_.position[m] = at.weights[0] * surface_.position[t[0]] + at.weights[1] * surface_.position[t[1]] +
                           at.weights[2] * surface_.position[t[2]];
    const double first = at.weights[0] + at.weights[1];
    surface_.source[m] =
        between_sources(between_sources(surface_.source[t[0]], surface_.source[t[1]], at.weights[1] / first),
                        surface_.source[t[2]], at.weights[2]);
    return m;
  }

  void place_corners() {
    std::optional<mesh::SurfaceSearch> search;
    for (const CornerPlace& place : options_.places) {
      Index node = 0;
      while (node < layout_.nodes.size() && layout_.node_position(node) != target_.corners[place.corner])
        ++node;
      if (node == layout_.nodes.size()) throw base::Error("internal", "a corner that is no node");
      if (place.vertex != no_index) {
        guide_.node_vertex[node] = place.vertex;
        continue;
      }
      if (!search) search.emplace(positions_, triangles_, host_);
      guide_.node_vertex[node] = vertex_at(search->nearest(place.point));
    }
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  const PatchGraph& target_;
  const DrawingOptions& options_;
  const base::Host& host_;
  Layout layout_;
  EditableSurface surface_;
  LayoutGuide guide_;
};

}  // namespace

Construction construct_on(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                          const PatchGraph& target, std::int64_t target_genus, const DrawingOptions& options,
                          const base::Host& host) {
  const auto topology = mesh::topology(positions, triangles, host);
  mesh::require_closed_manifold(topology);
  if (!topology.genus) throw base::Error("not-connected", "a polycube map needs one closed, oriented surface");
  if (*topology.genus != target_genus)
    throw base::Error("wrong-genus", "the surface has genus " + std::to_string(*topology.genus) + ", the polycube " +
                                         std::to_string(target_genus));
  Construction best = DrawnConstruction(positions, triangles, target, options, host).run();
  // A map pulls arcs to better places than those that they were drawn along; drawn there, they are straight again.
  constexpr double enough = 0.99;
  const auto score = [](const Construction& made) {
    return made.distortion.angle_weighted_mean + made.distortion.area_weighted_mean;
  };
  // Nothing is better than an isometry.
  constexpr double isometry = 2, rounding = 1e-9;
  if (score(best) <= isometry + rounding) return best;
  for (int i = 0; i < options.redrawings; ++i) {
    DrawingOptions again;
    again.places = options.places;
    again.model = &best.map;
    try {
      Construction next = DrawnConstruction(positions, triangles, target, again, host).run();
      host.log("drawn again: " + std::to_string(score(best)) + " to " + std::to_string(score(next)));
      const bool gained = score(next) < enough * score(best);
      next.tried += best.tried;
      next.valid += best.valid;
      if (score(next) < score(best)) best = std::move(next);
      if (!gained) break;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      break;
    }
  }
  if (options.smoothing_rounds > 0) {
    Array<Vector3> held(host.memory);
    for (const CornerPlace& place : options.places)
      held.push_back(target.corners[place.corner]);
    best.distortion = improve_map(best.map, best.certificate,
                                  {.rounds = options.smoothing_rounds, .domain = false, .held_corners = held}, host);
  }
  return best;
}

}  // namespace orbicube::polycube

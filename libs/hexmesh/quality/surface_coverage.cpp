#include "hexmesh/quality/surface_coverage.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/threads/pieces.h"
#include "mesh/search/nearest.h"

namespace orbicube::hexmesh {

SurfaceCoverage::SurfaceCoverage(const HexMesh& mesh, const SurfaceTarget& target, double distance,
                                 const base::Host& host)
    : mesh_(mesh),
      target_(target),
      distance_(distance),
      host_(host),
      samples_(host.memory),
      uncovered_(host.memory),
      homes_(host.memory) {
  take_samples();
  if (distance > 0) find_homes();
}

template <class Body>
void SurfaceCoverage::for_pieces(std::size_t count, const Body& body) const {
  base::parallel_pieces(host_, "smooth", count, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      body(i);
  });
}

void SurfaceCoverage::take_samples() {
  // Vertices and centers of the surface, few enough to visit all of them quickly.
  constexpr std::size_t max_samples = 30000;
  const auto& triangles = target_.triangles();
  const std::size_t all = target_.positions().size() + triangles.size();
  const std::size_t stride = (all + max_samples - 1) / max_samples;
  const auto corner = [&](const mesh::Triangle& t, std::size_t k) { return target_.positions()[t[k]]; };
  const auto normal = [&](const mesh::Triangle& t) -> Vector3 {
    return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
  };
  Array<Vector3> of_vertex(target_.positions().size(), Vector3::Zero(), host_.memory);
  for (const mesh::Triangle& t : triangles) {
    for (const Index v : t)
      of_vertex[v] += normal(t);
  }
  for (std::size_t i = 0; i < all; i += stride) {
    if (i < target_.positions().size()) {
      samples_.push_back({target_.positions()[i], of_vertex[i]});
      continue;
    }
    const mesh::Triangle& t = triangles[i - target_.positions().size()];
    samples_.push_back({(corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3, normal(t)});
  }
}

// Returns both halves of each quad, in both ways.
Array<mesh::Triangle> SurfaceCoverage::halves_of_quads() const {
  Array<mesh::Triangle> halves(host_.memory);
  for (const Quad& q : mesh_.quads) {
    halves.push_back({q[0], q[1], q[2]});
    halves.push_back({q[0], q[2], q[3]});
    halves.push_back({q[0], q[1], q[3]});
    halves.push_back({q[1], q[2], q[3]});
  }
  return halves;
}

// Finds the quad that each sample belongs to: the mesh began where the map has it, which is near to all of the surface.
void SurfaceCoverage::find_homes() {
  const Array<mesh::Triangle> halves = halves_of_quads();
  const mesh::SurfaceSearch search(mesh_.positions, halves, host_);
  homes_.resize(samples_.size());
  for_pieces(samples_.size(), [&](std::size_t i) { homes_[i] = search.nearest(samples_[i].position).triangle / 4; });
  host_.report("smooth", 0, 0);
}

// Returns how far a quad is from the surface, at its corners and half-way between any two.
double SurfaceCoverage::gap_of_quad(std::size_t i) const {
  double most = 0;
  for (const Index a : mesh_.quads[i]) {
    for (const Index b : mesh_.quads[i]) {
      if (b < a) continue;
      const Vector3 p = 0.5 * (mesh_.positions[a] + mesh_.positions[b]);
      most = std::max(most, (target_.nearest(p).position - p).norm());
    }
  }
  return most;
}

void SurfaceCoverage::find() {
  const Array<mesh::Triangle> halves = halves_of_quads();
  const mesh::SurfaceSearch search(mesh_.positions, halves, host_);
  uncovered_.resize(samples_.size());
  for_pieces(samples_.size(), [&](std::size_t i) {
    // Most often what was nearest before, or beside it.
    const mesh::SurfacePoint found = search.nearest(samples_[i].position, uncovered_[i].half);
    const mesh::Triangle& t = halves[found.triangle];
    const Vector3 n =
        (mesh_.positions[t[1]] - mesh_.positions[t[0]]).cross(mesh_.positions[t[2]] - mesh_.positions[t[0]]);
    // The other side of a thin part is nearer, but not what belongs here.
    const bool same_side = n.dot(samples_[i].normal) > 0;
    uncovered_[i] = {found.triangle, t, found.weights, found.position, same_side ? found.distance : 0, found.distance};
  });
  host_.report("smooth", 0, 0);
}

void SurfaceCoverage::add_pulls(std::span<Pull> pulls) const {
  constexpr double near = 0.1, weight = 20;
  // What is far counts more, so that protrusions are reached.
  constexpr double far = 0.3, most = 10;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Uncovered& u = uncovered_[i];
    if (u.distance < near) continue;
    const Vector3 n = (samples_[i].position - u.position) / u.distance;
    const double strength = std::clamp(u.distance * u.distance / (far * far), 1.0, most);
    for (std::size_t k = 0; k < 3; ++k) {
      const double w = u.weights[static_cast<Eigen::Index>(k)];
      if (w < 1e-3) continue;
      const Index v = u.vertices[k];
      const double move = std::min(1.0, u.distance) * w / u.weights.squaredNorm();
      pulls[v].to_plane(n, mesh_.positions[v] + move * n, weight * w * strength);
    }
  }
}

void SurfaceCoverage::hold_what_is_far(HexBoundary& boundary) const {
  Array<std::uint8_t> far(mesh_.quads.size(), 0, host_.memory);
  for_pieces(mesh_.quads.size(), [&](std::size_t i) { far[i] = gap_of_quad(i) > distance_; });
  host_.report("smooth", 0, 0);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (uncovered_[i].gap > distance_) far[homes_[i]] = 1;
  }
  Array<std::uint8_t> held(mesh_.positions.size(), 0, host_.memory);
  for (std::size_t i = 0; i < mesh_.quads.size(); ++i) {
    for (const Index v : mesh_.quads[i])
      held[v] |= far[i];
  }
  for (const Index v : boundary.vertices()) {
    if (held[v] != 0)
      boundary.hold_more(v);
    else
      boundary.hold_less(v);
  }
}

double SurfaceCoverage::excess() {
  if (distance_ == 0) return 0;
  find();
  double most = 0;
  for (const Uncovered& u : uncovered_)
    most = std::max(most, u.gap);
  Array<double> gaps(mesh_.quads.size(), 0, host_.memory);
  for_pieces(mesh_.quads.size(), [&](std::size_t i) { gaps[i] = gap_of_quad(i); });
  host_.report("smooth", 0, 0);
  for (const double gap : gaps)
    most = std::max(most, gap);
  return std::max(0.0, most / distance_ - 1);
}

}  // namespace orbicube::hexmesh

#include "volume_map/quality/hex_smoothing.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/threads/pieces.h"
#include "mesh/search/nearest.h"
#include "volume_map/quality/hex_tetrahedra.h"
#include "volume_map/untangle/local_untangling.h"
#include "volume_map/untangle/newton.h"

namespace orbicube::volume_map {
namespace {

constexpr std::size_t hexahedra_between_reports = 4096;
constexpr double padding_length = 0.6;  // across the layer at the boundary

class Smoothing {
 public:
  Smoothing(HexMesh& mesh, HexBoundary& boundary, const SurfaceTarget& target, const HexSmoothingOptions& options,
            const base::Host& host)
      : mesh_(mesh),
        boundary_(boundary),
        target_(target),
        options_(options),
        host_(host),
        anchor_(mesh.positions, host.memory),
        elements_(host.memory),
        edges_(mesh.hexahedra.size(), no_index, host.memory),
        pulls_(mesh.positions.size(), Pull(), host.memory),
        stiffness_(mesh.positions.size(), 1, host.memory),
        samples_(host.memory),
        variables_(mesh.positions, {}, {}, host.memory) {
    elements_.reserve(corner_tetrahedra * mesh.hexahedra.size());
    for (const Hexahedron& h : mesh.hexahedra) {
      for (std::size_t k = 0; k < corner_tetrahedra; ++k)
        elements_.push_back(hex_tetrahedra[k].element(h));
    }
    // Vertices and centers of the surface, few enough to visit all of them quickly.
    constexpr std::size_t max_samples = 30000;
    const auto& triangles = target.triangles();
    const std::size_t all = target.positions().size() + triangles.size();
    const std::size_t stride = (all + max_samples - 1) / max_samples;
    const auto corner = [&](const mesh::Triangle& t, std::size_t k) { return target.positions()[t[k]]; };
    const auto normal = [&](const mesh::Triangle& t) -> Vector3 {
      return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
    };
    Array<Vector3> of_vertex(target.positions().size(), Vector3::Zero(), host.memory);
    for (const mesh::Triangle& t : triangles) {
      for (const Index v : t)
        of_vertex[v] += normal(t);
    }
    for (std::size_t i = 0; i < all; i += stride) {
      if (i < target.positions().size()) {
        samples_.push_back({target.positions()[i], of_vertex[i]});
        continue;
      }
      const mesh::Triangle& t = triangles[i - target.positions().size()];
      samples_.push_back({(corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3, normal(t)});
    }
    if (options.distance > 0) find_homes();
  }

  bool run() {
    set_shapes(0);
    begin(variables_.start());
    // Of eps, a step. The start is near to a mesh without inverted corners most often, so that it may fall quickly.
    bool positive = untangle(first_pull, quick);
    if (!positive) {
      newton_->restart(variables_.start());
      positive = untangle(first_pull, slow);
    }
    if (!positive) return false;
    Array<Vector3> best_positions(host_.memory);
    double best = -std::numeric_limits<double>::infinity();
    for (int round = 0; round < options_.rounds; ++round) {
      host_.report("smooth", static_cast<std::uint64_t>(round), static_cast<std::uint64_t>(options_.rounds));
      const double progress = std::min(1.0, round / (0.5 * options_.rounds));
      const double own = std::min(1.0, round / 6.0), pull = first_pull * std::pow(last_pull / first_pull, progress);
      // Where corners have had time to become good, and before it is too late.
      constexpr double little = 0.02;
      if (round % 4 == 0 && 2 * round >= options_.rounds && 10 * round <= 9 * options_.rounds)
        untwist(own, pull, little);
      set_shapes(own);
      if (round >= 4) set_weights();
      if (round % 4 == 0 && 10 * round >= 4 * options_.rounds && 10 * round <= 7 * options_.rounds)
        release_what_is_bad();
      if (options_.lift && round >= 4 && round % 2 == 0)
        boundary_.lift(mesh_.positions, mesh_.quads, mesh_.quad_patches, host_);
      set_pulls(pull);
      if (round % 2 == 0) find_uncovered();
      // Not before the pulls have done most of what they can.
      if (round % 2 == 0 && 10 * round >= 3 * options_.rounds && options_.distance > 0) hold_what_is_far();
      add_uncovered();
      EnergyValue now = energy_->value(newton_->values(), 0);
      for (int k = 0; k < 2; ++k) {
        const double before = now.energy;
        newton_->step(0, {.products = 60, .tolerance = 3e-2}, now);
        if (now.energy > before * (1 - 1e-5)) break;
      }
      variables_.expand(newton_->values(), mesh_.positions);
      // Projections may change from round to round: the best of the last rounds counts.
      if (4 * round < 3 * options_.rounds) continue;
      const double score = worst() - excess();
      if (score > best) {
        best = score;
        best_positions.assign(mesh_.positions.begin(), mesh_.positions.end());
      }
    }
    if (!best_positions.empty()) mesh_.positions = best_positions;
    untwist_the_last();
    return true;
  }

 private:
  static constexpr double quick = 0.5, slow = 0.1;
  static constexpr double first_pull = 20, last_pull = 1000;
  static constexpr double volume_weight = 0.1;

  // From these values of the variables on, with the elements that there are now.
  void begin(std::span<const double> values) {
    newton_.reset();
    energy_.emplace(elements_, variables_, volume_weight, host_);
    energy_->set_pulls(pulls_);
    newton_.emplace(*energy_, values, host_);
  }

  // A determinant that may be negative is worse than any corner.
  double worst() const {
    double result = 1;
    for (std::size_t i = 0; i < mesh_.hexahedra.size(); ++i) {
      if (i % hexahedra_between_reports == 0) host_.report("smooth", 0, 0);
      const Hexahedron& h = mesh_.hexahedra[i];
      const double least = min_bezier(mesh_.positions, h);
      result = std::min(result, least > 0 ? scaled_jacobian(mesh_.positions, h) : least);
    }
    return result;
  }

  // Until all elements are positive. The mesh follows.
  bool untangle(double pull, double min_fall) {
    constexpr double hopeless_eps = 1e-6;
    constexpr int turns = 8;  // of steps, between tries to untangle the few that are left
    double eps = 0;
    for (int k = 0; k < options_.untangling_steps; ++k) {
      variables_.expand(newton_->values(), mesh_.positions);
      set_pulls(pull);
      EnergyValue now = energy_->value(newton_->values(), 1);
      host_.report("untangle", static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(options_.untangling_steps),
                   static_cast<double>(now.inverted));
      if (now.inverted == 0) return true;
      if (k == 0) eps = std::clamp(std::hypot(1e-3, 0.2 * now.min_determinant), 1e-3, 1.0);
      if (k > 0 && k % turns == 0 && few(now.inverted)) {
        const bool done = untangle_neighborhoods();
        newton_->restart(values());
        if (done) return true;
      }
      if (eps < hopeless_eps) break;
      now = energy_->value(newton_->values(), eps);
      const double before = now.energy;
      newton_->step(eps, {.products = 80}, now);
      const double sigma = std::max(min_fall, 1 - now.energy / before);
      const double least = now.min_determinant, m = std::hypot(least, eps);
      eps = std::max(eps * (least < 0 ? 1 - sigma * m / (std::abs(least) + m) : 1 - sigma), 1e-9);
    }
    variables_.expand(newton_->values(), mesh_.positions);
    return energy_->value(newton_->values(), 1).inverted == 0;
  }

  bool few(std::size_t inverted) const { return 1000 * inverted < elements_.size(); }

  // Untangles inverted elements, each group of elements in its neighborhood. Returns whether nothing is inverted any
  // more.
  bool untangle_neighborhoods() {
    constexpr int max_steps = 60;
    const Array<std::uint8_t> none_fixed(3 * mesh_.positions.size(), 0, host_.memory);
    return untangle_locally(elements_, none_fixed, volume_weight, max_steps, mesh_.positions, host_, pulls_).done;
  }

  // Of the variables, where the mesh is now.
  Array<double> values() const {
    Array<double> result(3 * mesh_.positions.size(), 0, host_.memory);
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      for (std::size_t a = 0; a < 3; ++a)
        result[variables_.of(v, a)] = mesh_.positions[v][static_cast<Eigen::Index>(a)];
    }
    return result;
  }

  // Where the best of all rounds has some that are twisted, they are untangled with what is beside them left alone
  // as far as that can be; what twists in turn is next.
  void untwist_the_last() {
    constexpr int max_turns = 4;
    const auto count = [&] {
      return std::count_if(mesh_.hexahedra.begin(), mesh_.hexahedra.end(),
                           [&](const Hexahedron& h) { return min_bezier(mesh_.positions, h) <= 0; });
    };
    auto fewest = count();
    Array<Vector3> best(mesh_.positions, host_.memory);
    for (int turn = 0; turn < max_turns && fewest > 0; ++turn) {
      untwist(1, last_pull, 0);
      const auto left = count();
      if (left >= fewest) continue;
      fewest = left;
      best = mesh_.positions;
    }
    mesh_.positions = best;
  }

  // Hexahedra whose corners are positive while the determinant inside may not be, or hardly: the tetrahedra along their
  // edges are untangled, and count from now on where that was possible.
  void untwist(double own, double pull, double least) {
    Array<Index> twisted(host_.memory);
    for (Index i = 0; i < mesh_.hexahedra.size(); ++i) {
      if (i % hexahedra_between_reports == 0) host_.report("smooth", 0, 0);
      if (edges_[i] == no_index && min_bezier(mesh_.positions, mesh_.hexahedra[i]) <= least) twisted.push_back(i);
    }
    if (twisted.empty()) return;
    const std::size_t elements = elements_.size();
    for (const Index i : twisted) {
      edges_[i] = static_cast<Index>(elements_.size());
      for (std::size_t k = corner_tetrahedra; k < hex_tetrahedra.size(); ++k)
        elements_.push_back(hex_tetrahedra[k].element(mesh_.hexahedra[i]));
    }
    set_shapes(own);
    set_pulls(pull);
    // In a small mesh a neighborhood is half of it, and a step for all of it costs little.
    constexpr std::size_t small = 20000;
    if (!untangle_neighborhoods() && elements_.size() < small) {
      const Array<double> reached = values();
      begin(reached);
      if (!untangle(pull, quick)) variables_.expand(reached, mesh_.positions);
    }
    // Those of hexahedra that stay twisted count no more.
    std::size_t end = elements;
    for (const Index i : twisted) {
      const std::size_t first = edges_[i];
      bool positive = true;
      for (std::size_t k = 0; k < edge_tetrahedra; ++k)
        positive &= elements_[first + k].jacobian(mesh_.positions).determinant() > 0;
      edges_[i] = positive ? static_cast<Index>(end) : no_index;
      for (std::size_t k = 0; k < edge_tetrahedra && positive; ++k)
        elements_[end++] = elements_[first + k];
    }
    elements_.resize(end);
    begin(values());
  }

  // Each tetrahedron of a hexahedron that counts, and its element.
  template <class Body>
  void for_tetrahedra(std::size_t hexahedron, const Body& body) {
    for (std::size_t k = 0; k < corner_tetrahedra; ++k)
      body(hex_tetrahedra[k], elements_[corner_tetrahedra * hexahedron + k]);
    if (edges_[hexahedron] == no_index) return;
    for (std::size_t k = 0; k < edge_tetrahedra; ++k)
      body(hex_tetrahedra[corner_tetrahedra + k], elements_[edges_[hexahedron] + k]);
  }

  // Every hexahedron is to be a box: a cube of edges 1 to begin with, then with its own mean lengths.
  void set_shapes(double own) {
    for (std::size_t i = 0; i < mesh_.hexahedra.size(); ++i) {
      if (i % hexahedra_between_reports == 0) host_.report("smooth", 0, 0);
      const Hexahedron& h = mesh_.hexahedra[i];
      const bool padding = i + options_.padding >= mesh_.hexahedra.size();
      std::array<double, 3> length;
      for (std::size_t d = 0; d < 3; ++d) {
        double mean = 0;
        for (const auto& e : edges_along[d])
          mean += 0.25 * (mesh_.positions[h[e[1]]] - mesh_.positions[h[e[0]]]).norm();
        const double wanted = d == 2 && padding ? padding_length : 1;
        length[d] = own * std::clamp(mean, 0.15, 3.0) + (1 - own) * wanted;
      }
      for_tetrahedra(i, [&](const HexTetrahedron& t, Element& element) { t.set_shape(length, element); });
    }
  }

  // What is not good enough counts more each time, and less again once it is, as multipliers of constraints do.
  void set_weights() {
    constexpr double enough = 0.7;
    for (std::size_t i = 0; i < mesh_.hexahedra.size(); ++i) {
      if (i % hexahedra_between_reports == 0) host_.report("smooth", 0, 0);
      for_tetrahedra(i, [&](const HexTetrahedron& t, Element& element) {
        const double ratio = enough / std::max(0.02, t.scaled_jacobian(mesh_.positions, element));
        element.weight = std::clamp(ratio * ratio * element.weight, 1.0, options_.max_weight);
      });
    }
    // What pulls to the surface is to keep pace.
    constexpr double light = 10;
    std::fill(stiffness_.begin(), stiffness_.end(), 1.0);
    for (const Element& e : elements_) {
      for (const Index v : e.corner)
        stiffness_[v] = std::max(stiffness_[v], e.weight / light);
    }
  }

  void set_pulls(double weight) {
    constexpr double stay = 0.02, anchor = 0.1;
    std::fill(pulls_.begin(), pulls_.end(), Pull());
    const auto vertices = boundary_.vertices();
    base::parallel_pieces(host_, "smooth", vertices.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Index v = vertices[i];
        Pull& pull = pulls_[v];
        pull.at = mesh_.positions[v];
        // What is fixed belongs where it began, not to another part of the surface that is nearer now.
        const double hold = boundary_.hold(v) - 1, part = hold / (hold + 30);
        boundary_.pull(v, (1 - part) * mesh_.positions[v] + part * anchor_[v], weight * stiffness_[v], pull);
        pull.to_point(mesh_.positions[v], stay);
        const auto kind = boundary_.kind(v);
        if (kind == HexBoundary::Kind::surface || kind == HexBoundary::Kind::patch || boundary_.hold(v) > 1)
          pull.to_point(anchor_[v], anchor * boundary_.hold(v));
      }
    });
  }

  // Both halves of each quad, in both ways.
  Array<mesh::Triangle> halves_of_quads() const {
    Array<mesh::Triangle> halves(host_.memory);
    for (const Quad& q : mesh_.quads) {
      halves.push_back({q[0], q[1], q[2]});
      halves.push_back({q[0], q[2], q[3]});
      halves.push_back({q[0], q[1], q[3]});
      halves.push_back({q[1], q[2], q[3]});
    }
    return halves;
  }

  template <class Body>
  void for_pieces(std::size_t count, const Body& body) const {
    base::parallel_pieces(host_, "smooth", count, 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        body(i);
    });
  }

  // The quad that each sample belongs to: the mesh began where the map has it, which is near to all of the surface.
  void find_homes() {
    const Array<mesh::Triangle> halves = halves_of_quads();
    const mesh::SurfaceSearch search(mesh_.positions, halves, host_);
    homes_.resize(samples_.size());
    for_pieces(samples_.size(), [&](std::size_t i) { homes_[i] = search.nearest(samples_[i].position).triangle / 4; });
    host_.report("smooth", 0, 0);
  }

  // How far a quad is from the surface, at its corners and half-way between any two.
  double gap_of_quad(std::size_t i) const {
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

  // Sharp edges are given up where hexahedra cannot follow them.
  void release_what_is_bad() {
    constexpr double bad = 0.5;
    for (const Hexahedron& h : mesh_.hexahedra) {
      if (scaled_jacobian(mesh_.positions, h) > bad) continue;
      for (const Index v : h) {
        if (boundary_.kind(v) != HexBoundary::Kind::inside) boundary_.release(v);
      }
    }
  }

  void hold_what_is_far() {
    Array<std::uint8_t> far(mesh_.quads.size(), 0, host_.memory);
    for_pieces(mesh_.quads.size(), [&](std::size_t i) { far[i] = gap_of_quad(i) > options_.distance; });
    host_.report("smooth", 0, 0);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (uncovered_[i].gap > options_.distance) far[homes_[i]] = 1;
    }
    Array<std::uint8_t> held(mesh_.positions.size(), 0, host_.memory);
    for (std::size_t i = 0; i < mesh_.quads.size(); ++i) {
      for (const Index v : mesh_.quads[i])
        held[v] |= far[i];
    }
    for (const Index v : boundary_.vertices()) {
      if (held[v] != 0)
        boundary_.hold_more(v);
      else
        boundary_.hold_less(v);
    }
  }

  // How much farther than requested the surface and the boundary are from each other, relative.
  double excess() {
    if (options_.distance == 0) return 0;
    find_uncovered();
    double most = 0;
    for (const Uncovered& u : uncovered_)
      most = std::max(most, u.gap);
    Array<double> gaps(mesh_.quads.size(), 0, host_.memory);
    for_pieces(mesh_.quads.size(), [&](std::size_t i) { gaps[i] = gap_of_quad(i); });
    host_.report("smooth", 0, 0);
    for (const double gap : gaps)
      most = std::max(most, gap);
    return std::max(0.0, most / options_.distance - 1);
  }

  // What of the surface the boundary is not at, and where it is nearest to that.
  void find_uncovered() {
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
      uncovered_[i] = {found.triangle, t, found.weights, found.position, same_side ? found.distance : 0,
                       found.distance};
    });
    host_.report("smooth", 0, 0);
  }

  void add_uncovered() {
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
        pulls_[v].to_plane(n, mesh_.positions[v] + move * n, weight * w * strength);
      }
    }
  }

  struct Sample {
    Vector3 position, normal;
  };
  struct Uncovered {
    Index half = no_index;  // of a quad
    mesh::Triangle vertices{};
    Vector3 weights = Vector3::Zero(), position = Vector3::Zero();
    double distance = 0;  // 0 where this is another side
    double gap = 0;
  };

  HexMesh& mesh_;
  HexBoundary& boundary_;
  const SurfaceTarget& target_;
  const HexSmoothingOptions& options_;
  const base::Host& host_;
  Array<Vector3> anchor_;
  Array<Element> elements_;  // eight a hexahedron, then those of edges
  Array<Index> edges_;       // of each hexahedron, where those begin if they count
  Array<Pull> pulls_;
  Array<double> stiffness_;  // of what pulls each vertex to the surface
  Array<Sample> samples_;
  Array<Uncovered> uncovered_{host_.memory};
  Array<Index> homes_{host_.memory};  // the quad of each sample
  Variables variables_;
  std::optional<FoldoverEnergy> energy_;
  std::optional<Newton> newton_;
};

}  // namespace

bool smooth_hexahedra(HexMesh& mesh, HexBoundary& boundary, const SurfaceTarget& target,
                      const HexSmoothingOptions& options, const base::Host& host) {
  return Smoothing(mesh, boundary, target, options, host).run();
}

}  // namespace orbicube::volume_map

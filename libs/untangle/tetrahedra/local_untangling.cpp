#include "untangle/tetrahedra/local_untangling.h"

#include <Eigen/Dense>
#include <algorithm>

#include "base/grouping.h"
#include "untangle/tetrahedra/newton.h"

namespace orbicube::untangle {
namespace {

class Neighborhoods {
 public:
  Neighborhoods(std::span<const Element> elements, std::span<const std::uint8_t> fixed, double lambda, int max_steps,
                std::span<Vector3> positions, const base::Host& host, std::span<const Pull> pulls)
      : elements_(elements),
        fixed_(fixed),
        lambda_(lambda),
        max_steps_(std::min(max_steps, steps_in_reason)),
        positions_(positions),
        host_(host),
        pulls_(pulls),
        incident_(host.memory),
        ring_(positions.size(), no_index, host.memory),
        place_(positions.size(), no_index, host.memory),
        taken_(elements.size(), 0, host.memory),
        region_(host.memory),
        held_(host.memory) {
    incident_.assign(positions.size(), [&](const auto& visit) {
      for (Index i = 0; i < elements.size(); ++i) {
        if (i % slab == 0) host.report("untangle", 0, 0);
        for (const Index v : elements[i].corner)
          visit(v, i);
      }
    });
  }

  // Sets the vertices that may move: those of elements that are not positive, and the given number of rings round them.
  // Returns how many such elements there are.
  std::size_t choose(Index rings) {
    for (const Index v : region_)
      ring_[v] = no_index;
    region_.clear();
    held_.clear();
    std::size_t inverted = 0;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      if (i % slab == 0) host_.report("untangle", 0, 0);
      const Element& e = elements_[i];
      if (e.jacobian(positions_).determinant() > 0) continue;
      ++inverted;
      for (const Index v : e.corner)
        visit(v, 0);
      if (std::none_of(e.corner.begin(), e.corner.end(), [&](Index v) { return can_move(v); }))
        held_.insert(held_.end(), e.corner.begin(), e.corner.end());
    }
    for (std::size_t i = 0; i < region_.size(); ++i) {
      const Index v = region_[i];
      if (ring_[v] == rings) break;
      for_neighbors(v, [&](Index w) { visit(w, ring_[v] + 1); });
    }
    return inverted;
  }
  std::size_t chosen() const { return region_.size(); }

  // Each connected part of what was chosen by itself.
  void untangle(LocalUntangling& result) {
    result.jammed.assign(positions_.size(), 0);
    for (const Index v : held_)
      result.jammed[v] = 1;
    Array<Index> vertices(host_.memory);
    Array<Element> around(host_.memory);
    Array<Index> used(host_.memory);
    for (const Index first : region_) {
      if (place_[first] != no_index) continue;
      vertices.clear();
      add(first, vertices);
      for (std::size_t i = 0; i < vertices.size(); ++i)
        for_neighbors(vertices[i], [&](Index w) {
          if (ring_[w] != no_index) add(w, vertices);
        });
      const std::size_t movable = vertices.size();
      around.clear();
      used.clear();
      for (std::size_t i = 0; i < movable; ++i) {
        const Index v = vertices[i];
        for (const Index e : incident_[v]) {
          if (taken_[e] != 0) continue;
          taken_[e] = 1;
          used.push_back(e);
        }
      }
      for (const Index i : used) {
        taken_[i] = 0;
        Element e = elements_[i];
        for (Index& v : e.corner) {
          add(v, vertices);
          v = place_[v];
        }
        around.push_back(e);
      }
      untangle_part(vertices, movable, around, result);
      // What is fixed is fixed by other parts as well.
      for (std::size_t i = movable; i < vertices.size(); ++i)
        place_[vertices[i]] = no_index;
    }
    for (const Index v : region_)
      place_[v] = no_index;
  }

 private:
  static constexpr std::size_t slab = 16384;
  static constexpr int steps_in_reason = 150;  // what takes more jams most often

  bool can_move(Index v) const {
    const std::size_t i = 3 * static_cast<std::size_t>(v);
    return fixed_[i] == 0 || fixed_[i + 1] == 0 || fixed_[i + 2] == 0;
  }
  void visit(Index v, Index ring) {
    if (ring_[v] != no_index || !can_move(v)) return;
    ring_[v] = ring;
    region_.push_back(v);
  }
  template <class Body>
  void for_neighbors(Index v, const Body& body) const {
    for (const Index i : incident_[v]) {
      for (const Index w : elements_[i].corner)
        body(w);
    }
  }
  void add(Index v, Array<Index>& vertices) {
    if (place_[v] != no_index) return;
    place_[v] = static_cast<Index>(vertices.size());
    vertices.push_back(v);
  }

  void untangle_part(std::span<const Index> vertices, std::size_t movable, std::span<const Element> around,
                     LocalUntangling& result) {
    constexpr int polish_steps = 10;
    constexpr double min_gain = 1e-3;
    Array<Vector3> start(vertices.size(), host_.memory);
    Array<std::uint8_t> fixed(3 * vertices.size(), 1, host_.memory);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      start[i] = positions_[vertices[i]];
      for (std::size_t a = 0; a < 3 && i < movable; ++a)
        fixed[3 * i + a] = fixed_[3 * static_cast<std::size_t>(vertices[i]) + a];
    }
    const Variables variables(start, fixed, {}, host_.memory);
    FoldoverEnergy energy(around, variables, lambda_, host_);
    Array<Pull> pulls(host_.memory);
    if (!pulls_.empty()) {
      pulls.resize(vertices.size());  // of those that stay: none
      for (std::size_t i = 0; i < movable; ++i)
        pulls[i] = pulls_[vertices[i]];
      energy.set_pulls(pulls);
    }
    Newton newton(energy, variables.start(), host_);
    const bool done = newton.untangle(max_steps_, 1, 1, {});
    if (done) newton.polish(polish_steps, min_gain, {.tolerance = 3e-2});
    result.steps += newton.steps();
    variables.expand(newton.values(), start);
    if (done) {
      for (std::size_t i = 0; i < movable; ++i)
        positions_[vertices[i]] = start[i];
      return;
    }
    for (const Element& e : around) {
      if (e.jacobian(start).determinant() > 0) continue;
      for (const Index v : e.corner)
        result.jammed[vertices[v]] = 1;
    }
  }

  std::span<const Element> elements_;
  std::span<const std::uint8_t> fixed_;
  double lambda_;
  int max_steps_;
  std::span<Vector3> positions_;
  const base::Host& host_;
  std::span<const Pull> pulls_;
  base::Groups<Index, Index> incident_;  // elements of each vertex
  Array<Index> ring_;                    // of vertices that may move: how far from what is not positive
  Array<Index> place_;                   // of a vertex in its part
  Array<std::uint8_t> taken_;            // elements of a part
  Array<Index> region_;                  // vertices that may move, by rings
  Array<Index> held_;                    // vertices of elements that are not positive and of which none may move
};

}  // namespace

LocalUntangling untangle_locally(std::span<const Element> elements, std::span<const std::uint8_t> fixed, double lambda,
                                 int max_steps, std::span<Vector3> positions, const base::Host& host,
                                 std::span<const Pull> pulls) {
  constexpr Index first_rings = 2;
  constexpr Index max_rings = 8;
  LocalUntangling result(host.memory);
  Neighborhoods neighborhoods(elements, fixed, lambda, max_steps, positions, host, pulls);
  for (Index rings = first_rings;; rings *= 2) {
    result.done = neighborhoods.choose(rings) == 0;
    if (result.done || rings > max_rings || 2 * neighborhoods.chosen() > positions.size()) break;
    neighborhoods.untangle(result);
  }
  if (result.done) result.jammed.clear();
  return result;
}

}  // namespace orbicube::untangle

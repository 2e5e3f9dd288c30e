// Where f has no value. Points that failed are separated from the interpolation points near the best one by planes:
// each halves the gap between the convex hull of points with a value and that of failed ones (the normal joins their
// nearest points, Mitchell, Demyanov and Malozemov 1974). A step within the planes follows an edge of the domain of f
// instead of running into it again, and each step that is tried halves what is not known of the edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "trust_region/interpolation.h"

namespace orbicube::trust_region {

class Edges {
 public:
  Edges(std::size_t n, std::pmr::memory_resource* memory);
  // Maximum number of points of the interpolation. Until the first failure nothing is kept.
  void allocate(std::size_t points);

  bool any() const { return failed_ > 0; }
  void add(const double* point);  // failed; the oldest is forgotten when there is no room
  void forget() { failed_ = next_ = planes_ = 0; }
  // u becomes best + C (u - old_best), as Interpolation::transform.
  void transform(const double* c, const double* old_best, const double* best);

  // Planes from the failed points within `reach` of the best point.
  void find(const Interpolation& interpolation, double reach);
  std::size_t count() const { return planes_; }
  // d from the best point is within plane k when normal'd <= room; room is not negative.
  const double* normal(std::size_t k) const { return normals_.data() + k * n_; }
  double room(std::size_t k) const { return rooms_[k]; }
  // The largest normal'd - room, 0 when d is within all planes.
  double excess(const double* d) const;
  // Moves d to the planes, by projections onto them in turn, and then shortens it.
  void confine(double* d) const;

  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    visit(std::span(&self.failed_, 1));
    visit(std::span(&self.next_, 1));
    visit(std::span(self.points_));
  }

 private:
  bool separate(std::size_t good, std::size_t bad);
  bool next_normal(std::size_t good, std::size_t left, std::size_t* nearest);
  std::size_t gather(const Interpolation& interpolation, double reach);
  double put(std::size_t i, const double* point);  // its offset; returns the square of its distance
  const double* failed_point(std::size_t j) const { return points_.data() + j * n_; }
  double* offset(std::size_t i) { return offsets_.data() + i * n_; }

  std::size_t n_, capacity_, max_good_ = 0;
  std::uint64_t failed_ = 0, next_ = 0;
  std::size_t planes_ = 0;
  base::Array<double> points_;             // failed ones, capacity x n
  base::Array<double> normals_, rooms_;    // of the planes
  base::Array<double> offsets_;            // points near the best, from it: with a value, then failed ones
  base::Array<double> weights_, along_;    // of them
  base::Array<double> difference_, best_;  // n
  base::Array<std::uint32_t> waiting_, chosen_;
};

}  // namespace orbicube::trust_region

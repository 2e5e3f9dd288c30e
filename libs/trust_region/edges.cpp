#include "trust_region/edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trust_region/dense.h"

namespace orbicube::trust_region {
namespace {

// Failed points that are kept: enough for the normals of several planes. More would be older ones, which a resolution
// that falls forgets anyway.
std::size_t kept(std::size_t n) {
  return std::min<std::size_t>(2 * n + 12, 80);
}

constexpr std::size_t max_planes = 8;
constexpr std::size_t max_exchanges = 400;
// Hulls are apart when the gap along the normal is this part of the distance between their nearest points.
constexpr double apart = 0.5, precise = 0.98;
// Where a plane stands between the hulls: a failed step has less information than a successful one along the edge. With
// 0.15 and 0.35 half as many runs again end far from the lowest point.
constexpr double part_of_gap = 0.25;

}  // namespace

Edges::Edges(std::size_t n, std::pmr::memory_resource* memory)
    : n_(n),
      capacity_(kept(n)),
      points_(memory),
      normals_(memory),
      rooms_(max_planes, 0.0, memory),
      offsets_(memory),
      weights_(memory),
      along_(memory),
      difference_(memory),
      best_(memory),
      waiting_(memory),
      chosen_(memory) {}

void Edges::allocate(std::size_t points) {
  max_good_ = std::min<std::size_t>(points, 2 * n_ + 12);
  points_.resize(capacity_ * n_);
  normals_.resize(max_planes * n_);
  const std::size_t count = max_good_ + 2 * capacity_;
  offsets_.resize(count * n_);
  weights_.resize(count);
  along_.resize(count);
  difference_.resize(n_);
  best_.resize(n_);
  waiting_.resize(capacity_);
  chosen_.resize(std::max(capacity_, points));
}

void Edges::add(const double* point) {
  if (points_.empty()) return;
  std::copy_n(point, n_, points_.data() + next_ * n_);
  next_ = (next_ + 1) % capacity_;
  failed_ = std::min<std::uint64_t>(failed_ + 1, capacity_);
}

void Edges::transform(const double* c, const double* old_best, const double* best) {
  for (std::size_t j = 0; j < failed_; ++j) {
    double* point = points_.data() + j * n_;
    for (std::size_t i = 0; i < n_; ++i)
      difference_[i] = point[i] - old_best[i];
    multiply(c, n_, n_, n_, difference_.data(), point);
    for (std::size_t i = 0; i < n_; ++i)
      point[i] += best[i];
  }
}

// The nearest points of the hulls of offsets [0, good) and [good, good + bad): into difference_ what leads from the
// first to the second. False when the hulls meet, or are too near for the arithmetic.
bool Edges::separate(std::size_t good, std::size_t bad) {
  const std::size_t count = good + bad;
  std::fill_n(weights_.begin(), count, 0.0);
  // Begins with the failed point that is nearest to the best one, which is the first of all.
  std::size_t nearest = good;
  double least = std::numeric_limits<double>::infinity(), size = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double square = dot(offset(i), offset(i), n_);
    size = std::max(size, square);
    if (i >= good && square < least) {
      least = square;
      nearest = i;
    }
  }
  weights_[0] = weights_[nearest] = 1;
  std::copy_n(offset(nearest), n_, difference_.data());
  double* p = difference_.data();
  for (std::size_t exchange = 0;; ++exchange) {
    const double square = dot(p, p, n_);
    if (!(square > 1e-12 * size)) return false;
    // Of the first hull what is farthest along p, of the second what is least far; and among those with weights the
    // opposite.
    std::size_t to_good = 0, from_good = good, to_bad = good, from_bad = count;
    multiply(offsets_.data(), n_, count, n_, p, along_.data());
    for (std::size_t i = 0; i < good; ++i) {
      if (along_[i] > along_[to_good]) to_good = i;
      if (weights_[i] > 0 && (from_good == good || along_[i] < along_[from_good])) from_good = i;
    }
    for (std::size_t i = good; i < count; ++i) {
      if (along_[i] < along_[to_bad]) to_bad = i;
      if (weights_[i] > 0 && (from_bad == count || along_[i] > along_[from_bad])) from_bad = i;
    }
    const double gap = along_[to_bad] - along_[to_good];
    if (gap >= precise * square) return true;
    if (exchange == max_exchanges) return gap >= apart * square;
    const bool second = along_[from_bad] - along_[to_bad] > along_[to_good] - along_[from_good];
    const std::size_t to = second ? to_bad : to_good, from = second ? from_bad : from_good;
    // Weight goes from one to the other, as much as makes |p| least.
    const double sign = second ? 1 : -1, slope = sign * (along_[from] - along_[to]);
    double length = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const double across = offset(to)[i] - offset(from)[i];
      length += across * across;
    }
    if (!(length > 0) || !(slope > 0)) return gap >= apart * square;
    const double moved = std::min(weights_[from], slope / length);
    weights_[from] = moved == weights_[from] ? 0 : weights_[from] - moved;
    weights_[to] += moved;
    for (std::size_t i = 0; i < n_; ++i)
      p[i] += sign * moved * (offset(to)[i] - offset(from)[i]);
  }
}

double Edges::put(std::size_t i, const double* point) {
  for (std::size_t k = 0; k < n_; ++k)
    offset(i)[k] = point[k] - best_[k];
  return dot(offset(i), offset(i), n_);
}

// The best point, then the nearest others within reach.
std::size_t Edges::gather(const Interpolation& interpolation, double reach) {
  std::size_t good = 1, near = 0;
  put(0, best_.data());
  for (std::size_t j = 0; j < interpolation.size(); ++j) {
    if (j != interpolation.best() && interpolation.distance_to_best(j) <= reach)
      chosen_[near++] = static_cast<std::uint32_t>(j);
  }
  if (near > max_good_ - 1) {
    std::sort(chosen_.begin(), chosen_.begin() + static_cast<std::ptrdiff_t>(near),
              [&](std::uint32_t a, std::uint32_t b) {
                const double to_a = interpolation.distance_to_best(a), to_b = interpolation.distance_to_best(b);
                return to_a < to_b || (to_a == to_b && a < b);
              });
    near = max_good_ - 1;
  }
  for (std::size_t j = 0; j < near; ++j)
    put(good++, interpolation.point(chosen_[j]));
  return good;
}

// The normal of the next plane into difference_: between the good points and all failed ones that wait, else those that
// lie beyond a plane of the nearest alone, else that one. False when it lies among the good ones.
bool Edges::next_normal(std::size_t good, std::size_t left, std::size_t* nearest) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t w = 0; w < left; ++w) {
    const double square = put(good + w, failed_point(waiting_[w]));
    if (square < least) {
      least = square;
      *nearest = w;
    }
  }
  if (separate(good, left)) return true;
  put(good, failed_point(waiting_[*nearest]));
  if (!separate(good, 1)) return false;
  double behind = 0;
  for (std::size_t i = 0; i < good; ++i)
    behind = std::max(behind, dot(difference_.data(), offset(i), n_));
  std::size_t bad = 0;
  for (std::size_t w = 0; w < left; ++w) {
    put(good + bad, failed_point(waiting_[w]));
    if (dot(difference_.data(), offset(good + bad), n_) > behind) ++bad;
  }
  if (separate(good, bad)) return true;
  put(good, failed_point(waiting_[*nearest]));
  return separate(good, 1);
}

void Edges::find(const Interpolation& interpolation, double reach) {
  planes_ = 0;
  if (failed_ == 0) return;
  std::copy_n(interpolation.point(interpolation.best()), n_, best_.data());
  const std::size_t good = gather(interpolation, reach);
  std::size_t left = 0;
  for (std::size_t j = 0; j < failed_; ++j) {
    if (put(good, failed_point(j)) <= reach * reach) waiting_[left++] = static_cast<std::uint32_t>(j);
  }
  while (left > 0 && planes_ < max_planes) {
    std::size_t nearest = 0, rest = left;
    if (next_normal(good, left, &nearest)) {
      const double length = norm(difference_.data(), n_);
      double behind = 0, ahead = std::numeric_limits<double>::infinity();
      double* to = normals_.data() + planes_ * n_;
      for (std::size_t i = 0; i < n_; ++i)
        to[i] = difference_[i] / length;
      for (std::size_t i = 0; i < good; ++i)
        behind = std::max(behind, dot(to, offset(i), n_));
      rest = 0;
      for (std::size_t w = 0; w < left; ++w) {
        put(good, failed_point(waiting_[w]));
        const double far = dot(to, offset(good), n_);
        if (far > behind) {
          ahead = std::min(ahead, far);
        } else {
          waiting_[rest++] = waiting_[w];
        }
      }
      if (rest < left) rooms_[planes_++] = behind + part_of_gap * (ahead - behind);
    }
    // One among points with values: a hole that no plane cuts off.
    if (rest == left) waiting_[nearest] = waiting_[--rest];
    left = rest;
  }
}

double Edges::excess(const double* d) const {
  double most = 0;
  for (std::size_t k = 0; k < planes_; ++k)
    most = std::max(most, dot(normal(k), d, n_) - room(k));
  return most;
}

void Edges::confine(double* d) const {
  constexpr int rounds = 8;
  for (int round = 0; round < rounds && excess(d) > 0; ++round) {
    for (std::size_t k = 0; k < planes_; ++k) {
      const double beyond = dot(normal(k), d, n_) - room(k);
      if (beyond > 0) add_scaled(d, -beyond, normal(k), n_);
    }
  }
  double part = 1;
  for (std::size_t k = 0; k < planes_; ++k) {
    const double far = dot(normal(k), d, n_);
    if (far > room(k)) part = std::min(part, room(k) / far);
  }
  for (std::size_t i = 0; part < 1 && i < n_; ++i)
    d[i] *= part;
}

}  // namespace orbicube::trust_region

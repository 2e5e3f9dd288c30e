#include "sphere_optimizer/limited_memory.h"

#include <algorithm>
#include <cmath>

#include "base/sums.h"
#include "sphere_optimizer/spheres.h"

namespace orbicube::sphere_optimizer {

LimitedMemory::LimitedMemory(const Shape& shape, std::size_t capacity, std::pmr::memory_resource* memory)
    : shape_(shape),
      capacity_(capacity),
      steps_(capacity * shape.size(), 0.0, memory),
      changes_(capacity * shape.size(), 0.0, memory),
      products_(capacity, 0.0, memory),
      coefficients_(capacity, 0.0, memory) {}

void LimitedMemory::transport(std::span<const double> from, std::span<const double> to, const Tick& tick) {
  with_dimension(shape_.dimension, [&](auto d) {
    for (std::size_t age = 0; age < count_; ++age) {
      tick();
      for (base::Array<double>* table : {&steps_, &changes_}) {
        double* v = row(*table, slot_of_age(age)).data();
        for (std::size_t i = 0; i < shape_.count; ++i)
          sphere_optimizer::transport(d, &from[i * d], &to[i * d], v + i * d);
      }
    }
  });
}

void LimitedMemory::push(std::span<const double> step, std::span<const double> change) {
  const double product = base::dot(step, change);
  const double step_square = base::dot(step, step), change_square = base::dot(change, change);
  // Cautious (Li and Fukushima 2001): with less curvature, H would be next to singular.
  if (!(product > 1e-10 * std::sqrt(step_square) * std::sqrt(change_square))) return;
  const std::size_t slot = count_ == 0 ? 0 : (newest_ + 1) % capacity_;
  std::copy(step.begin(), step.end(), row(steps_, slot).begin());
  std::copy(change.begin(), change.end(), row(changes_, slot).begin());
  products_[slot] = product;
  newest_ = slot;
  count_ = std::min<std::uint64_t>(count_ + 1, capacity_);
}

void LimitedMemory::descend(std::span<const double> gradient, std::span<const double> curvature,
                            std::span<double> direction, const Tick& tick) {
  const std::size_t n = shape_.size();
  for (std::size_t j = 0; j < n; ++j)
    direction[j] = -gradient[j];
  const auto add = [&](double factor, std::span<const double> v) {
    for (std::size_t j = 0; j < n; ++j)
      direction[j] += factor * v[j];
  };
  for (std::size_t age = 0; age < count_; ++age) {
    tick();
    const std::size_t slot = slot_of_age(age);
    coefficients_[slot] = base::dot(row(steps_, slot), direction) / products_[slot];
    add(-coefficients_[slot], row(changes_, slot));
  }
  const std::span<const double> change = row(changes_, newest_);
  const std::size_t d = shape_.dimension;
  const double square = base::blocked_sum(shape_.count, [&](std::size_t i) {
    double sum = 0;
    for (std::size_t k = i * d; k < (i + 1) * d; ++k)
      sum += change[k] * change[k];
    return sum / curvature[i];
  });
  const double scale = products_[newest_] / square;
  for (std::size_t i = 0; i < shape_.count; ++i) {
    for (std::size_t k = i * d; k < (i + 1) * d; ++k)
      direction[k] *= scale / curvature[i];
  }
  for (std::size_t age = count_; age-- > 0;) {
    tick();
    const std::size_t slot = slot_of_age(age);
    add(coefficients_[slot] - base::dot(row(changes_, slot), direction) / products_[slot], row(steps_, slot));
  }
}

}  // namespace orbicube::sphere_optimizer

#include "sphere_optimizer/limited_memory.h"

#include <algorithm>

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

void LimitedMemory::transport(std::span<const double> from, std::span<const double> to, const base::Host& host) {
  with_dimension(shape_.dimension, [&](auto d) {
    for (std::size_t age = 0; age < count_; ++age) {
      host.report("sphere optimizer: memory", age, count_);
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
  scale_ = product / change_square;
  newest_ = slot;
  count_ = std::min<std::uint64_t>(count_ + 1, capacity_);
}

void LimitedMemory::descend(std::span<const double> gradient, std::span<double> direction, const base::Host& host) {
  const std::size_t n = shape_.size();
  for (std::size_t j = 0; j < n; ++j)
    direction[j] = -gradient[j];
  const auto add = [&](double factor, std::span<const double> v) {
    for (std::size_t j = 0; j < n; ++j)
      direction[j] += factor * v[j];
  };
  for (std::size_t age = 0; age < count_; ++age) {
    host.report("sphere optimizer: direction", age, 2 * count_);
    const std::size_t slot = slot_of_age(age);
    coefficients_[slot] = base::dot(row(steps_, slot), direction) / products_[slot];
    add(-coefficients_[slot], row(changes_, slot));
  }
  for (std::size_t j = 0; j < n; ++j)
    direction[j] *= scale_;
  for (std::size_t age = count_; age-- > 0;) {
    host.report("sphere optimizer: direction", 2 * count_ - age - 1, 2 * count_);
    const std::size_t slot = slot_of_age(age);
    add(coefficients_[slot] - base::dot(row(changes_, slot), direction) / products_[slot], row(steps_, slot));
  }
}

}  // namespace orbicube::sphere_optimizer

#include "sphere_map/optimization/dependency_levels.h"

namespace orbicube::sphere_map {

std::size_t DependencyLevels::sort() {
  std::uint32_t end = first_;
  for (const std::uint32_t dependency_level : wave_)
    end = std::max(end, dependency_level + 1);
  const std::size_t dependency_levels = end - first_;
  begin_.assign(dependency_levels + 1, 0);
  for (const std::uint32_t dependency_level : wave_)
    ++begin_[dependency_level - first_ + 1];
  for (std::size_t w = 0; w < dependency_levels; ++w)
    begin_[w + 1] += begin_[w];
  order_.resize(wave_.size());
  for (std::size_t step = wave_.size(); step-- > 0;)
    order_[--begin_[wave_[step] - first_ + 1]] = static_cast<Index>(step);
  // Each dependency_level's end has become its begin.
  begin_.erase(begin_.begin());
  begin_.push_back(wave_.size());
  wave_.clear();
  first_ = end;
  return dependency_levels;
}

void DependencyLevels::release() {
  for (Array<std::uint32_t>* array : {&last_write_, &last_read_, &wave_})
    *array = Array<std::uint32_t>(array->get_allocator());
  order_ = Array<Index>(order_.get_allocator());
}

}  // namespace orbicube::sphere_map

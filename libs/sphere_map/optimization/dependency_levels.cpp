#include "sphere_map/optimization/dependency_levels.h"

#include "base/grouping.h"

namespace orbicube::sphere_map {

std::size_t DependencyLevels::sort() {
  std::uint32_t end = first_;
  for (const std::uint32_t dependency_level : wave_)
    end = std::max(end, dependency_level + 1);
  const std::size_t dependency_levels = end - first_;
  begin_.resize(dependency_levels + 1);
  base::group_by_key(
      std::span(begin_),
      [&](const auto& visit) {
        for (std::size_t step = 0; step < wave_.size(); ++step)
          visit(wave_[step] - first_, static_cast<Index>(step));
      },
      [&](std::size_t count) { order_.resize(count); }, [&](std::size_t at, Index step) { order_[at] = step; });
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

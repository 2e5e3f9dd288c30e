#include "sphere_map/optimization/waves.h"

namespace orbicube::sphere_map {

std::size_t Waves::sort() {
  std::uint32_t end = first_;
  for (const std::uint32_t wave : wave_)
    end = std::max(end, wave + 1);
  const std::size_t waves = end - first_;
  begin_.assign(waves + 1, 0);
  for (const std::uint32_t wave : wave_)
    ++begin_[wave - first_ + 1];
  for (std::size_t w = 0; w < waves; ++w)
    begin_[w + 1] += begin_[w];
  order_.resize(wave_.size());
  for (std::size_t step = wave_.size(); step-- > 0;)
    order_[--begin_[wave_[step] - first_ + 1]] = static_cast<Index>(step);
  // Each wave's end has become its begin.
  begin_.erase(begin_.begin());
  begin_.push_back(wave_.size());
  wave_.clear();
  first_ = end;
  return waves;
}

void Waves::release() {
  for (Array<std::uint32_t>* array : {&last_write_, &last_read_, &wave_})
    *array = Array<std::uint32_t>(array->get_allocator());
  order_ = Array<Index>(order_.get_allocator());
}

}  // namespace orbicube::sphere_map

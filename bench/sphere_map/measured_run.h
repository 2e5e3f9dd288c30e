// One map with its figures, CPU time and memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <functional>
#include <memory_resource>

#include "base/host.h"
#include "mesh/mesh.h"
#include "sphere_map/measure.h"

namespace orbicube::bench {

// The most that was allocated at once.
class CountingMemory final : public std::pmr::memory_resource {
 public:
  std::size_t peak() const { return peak_; }

 private:
  void* do_allocate(std::size_t size, std::size_t alignment) override {
    now_ += size;
    peak_ = std::max(peak_, now_);
    return std::pmr::new_delete_resource()->allocate(size, alignment);
  }
  void do_deallocate(void* pointer, std::size_t size, std::size_t alignment) override {
    now_ -= size;
    std::pmr::new_delete_resource()->deallocate(pointer, size, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  std::size_t now_ = 0;
  std::size_t peak_ = 0;
};

inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct MeasuredRun {
  sphere_map::Array<mesh::Vector3> directions;
  sphere_map::Measurement figures;  // at weights (0.1, 1)
  double seconds = 0;               // of CPU, one thread
  std::size_t peak_bytes = 0;
};

// `map` answers the directions of the surface, computed with the host that it is given.
inline MeasuredRun measured_run(const mesh::Mesh& surface,
                                const std::function<sphere_map::Array<mesh::Vector3>(const base::Host&)>& map) {
  CountingMemory memory;
  base::Host host;
  host.memory = &memory;
  host.thread_count = 1;
  MeasuredRun result;
  const double start = cpu_seconds();
  {
    const auto directions = map(host);
    result.seconds = cpu_seconds() - start;
    result.directions.assign(directions.begin(), directions.end());
  }
  result.peak_bytes = memory.peak();
  result.figures = sphere_map::measure(surface.positions, surface.triangles, result.directions, 0.1, 1, base::Host());
  return result;
}

}  // namespace orbicube::bench

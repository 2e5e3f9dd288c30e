// What the benchmarks measure with: CPU time, and the most memory that a host lent at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <memory_resource>

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

}  // namespace orbicube::bench

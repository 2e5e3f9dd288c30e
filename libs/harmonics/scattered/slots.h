// Places to work in, one for each task that runs at a time. A thread takes the first that is free, so that one thread
// alone stays in one place, which its cache then has.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <thread>

#include "base/host.h"

namespace orbicube::harmonics {

class Slots {
 public:
  static constexpr std::size_t max_count = 16;

  explicit Slots(const base::Host& host)
      : count_(host.executor ? max_count : std::min<std::size_t>(max_count, threads(host))) {}

  std::size_t count() const { return count_; }

  // body(task, slot) for tasks first to first + number - 1, of which at most max_count run at a time.
  template <class Body>
  void run(const base::Host& host, std::size_t first, std::size_t number, const Body& body) {
    host.parallel_for(number, [&](std::size_t k) {
      const Taken taken(used_);
      body(first + k, taken.slot);
    });
  }

  // The same for tasks 0 to count - 1, with a report after at most max_count of them.
  template <class Body>
  void run_all(std::size_t count, const char* phase, const base::Host& host, const Body& body) {
    for (std::size_t begin = 0; begin < count; begin += max_count) {
      host.report(phase, begin, count);
      run(host, begin, std::min(max_count, count - begin), body);
    }
  }

 private:
  static unsigned threads(const base::Host& host) {
    return host.thread_count != 0 ? host.thread_count : std::max(1u, std::thread::hardware_concurrency());
  }

  struct Taken {
    explicit Taken(std::atomic<std::uint32_t>& all) : used(all) {
      for (std::uint32_t now = used.load();;) {
        slot = static_cast<std::size_t>(std::countr_one(now));
        if (used.compare_exchange_weak(now, now | (1U << slot))) return;
      }
    }
    ~Taken() { used.fetch_and(~(1U << slot)); }
    Taken(const Taken&) = delete;
    Taken& operator=(const Taken&) = delete;
    std::atomic<std::uint32_t>& used;
    std::size_t slot = 0;
  };

  std::size_t count_;
  std::atomic<std::uint32_t> used_{0};
};

}  // namespace orbicube::harmonics

// Threads that stay for many short parallel loops, one after another.
#pragma once

#include <memory>

#include "base/host.h"

namespace orbicube::base {

// A loop costs about a microsecond while the threads are awake: they look for the next one for some microseconds before
// they go to sleep. With a host's own executor every loop goes there.
class ThreadPool {
 public:
  // `host` must outlive the pool. Threads that cannot be had are done without.
  explicit ThreadPool(const Host& host);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  // Calls body(i) for every i in [0, count), on any of the threads and on the caller's. What is computed must not
  // depend on the order. The first exception of a body ends the hand-out of further ones and is rethrown here. Not to
  // be called from a body, nor from two threads at once.
  template <class Body>
  void run(std::size_t count, const Body& body) const {
    if (count == 1) {
      body(std::size_t{0});
      return;
    }
    run(count, &body, [](const void* b, std::size_t i) { (*static_cast<const Body*>(b))(i); });
  }

  // run() over [0, total) in pieces: body(begin, end) with at most `piece` between them.
  template <class Body>
  void run_pieces(std::size_t total, std::size_t piece, const Body& body) const {
    run((total + piece - 1) / piece,
        [&](std::size_t i) { body(i * piece, total < (i + 1) * piece ? total : (i + 1) * piece); });
  }

 private:
  using Call = void (*)(const void* body, std::size_t i);
  void run(std::size_t count, const void* body, Call call) const;

  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace orbicube::base

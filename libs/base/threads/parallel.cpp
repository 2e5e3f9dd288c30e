#include "base/threads/parallel.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

#include "base/threads/cancellation.h"
#include "base/threads/first_exception.h"

namespace orbicube::base {
void parallel_for(const Executor& executor, unsigned thread_count, std::size_t count,
                  const std::function<void(std::size_t)>& body) {
  FirstException first;
  if (executor) {
    // An exception must not travel through the host's threads, which may be C.
    executor(count, [&](std::size_t i) {
      if (!first.failed()) first.guard([&] { body(i); });
    });
    first.rethrow();
    return;
  }
  const std::size_t cores = thread_count != 0 ? thread_count : std::max(1u, std::thread::hardware_concurrency());
  const std::size_t workers = std::min(count, cores);
  if (workers <= 1) {
    for (std::size_t i = 0; i < count; ++i)
      body(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i; !first.failed() && (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) {
      first.guard([&] { body(i); });
    }
  };
  std::vector<std::jthread> threads;
  threads.reserve(workers - 1);
  for (std::size_t i = 0; i + 1 < workers; ++i) {
    try {
      threads.emplace_back(work);
    } catch (const std::system_error&) {
      break;  // no more threads to be had: those that run, and the caller, do the work
    }
  }
  // Joins also when this thread ends inside a callback: what the others work on is on its stack.
  struct Join {
    std::vector<std::jthread>& threads;
    ~Join() {
      const CancellationOff off;
      threads.clear();
    }
  };
  {
    const Join join{threads};
    work();
  }
  first.rethrow();
}

}  // namespace orbicube::base

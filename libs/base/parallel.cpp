#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace orbicube::base {
namespace {

// Remembers the first exception of any piece.
class FirstException {
 public:
  template <class Call>
  void guard(const Call& call) noexcept {
    try {
      call();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!exception_) exception_ = std::current_exception();
      failed_.store(true, std::memory_order_relaxed);
    }
  }
  bool failed() const { return failed_.load(std::memory_order_relaxed); }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr exception_;
  std::atomic<bool> failed_{false};
};

}  // namespace

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
  work();
  threads.clear();  // joins
  first.rethrow();
}

}  // namespace orbicube::base

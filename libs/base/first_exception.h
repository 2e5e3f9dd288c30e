// The first exception of any of several pieces of work.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>

namespace orbicube::base {

class FirstException {
 public:
  // Calls `call`; what it throws is kept when it is the first.
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

  // Throws what was kept and forgets it.
  void rethrow() {
    if (!exception_) return;
    const std::exception_ptr exception = exception_;
    exception_ = nullptr;
    failed_.store(false, std::memory_order_relaxed);
    std::rethrow_exception(exception);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr exception_;
  std::atomic<bool> failed_{false};
};

}  // namespace orbicube::base

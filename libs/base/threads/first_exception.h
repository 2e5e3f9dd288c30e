// The first exception of any of several pieces of work.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>

#include "base/catch_all.h"
#include "base/error.h"

namespace orbicube::base {

class FirstException {
 public:
  // Calls `call`; what it throws is kept when it is the first. Only the end of the thread passes through: the work is
  // then not done, which is kept as cancelled.
  template <class Call>
  void guard(const Call& call) {
    catch_all([&] { call(); }, [&] { keep(std::current_exception()); },
              [&] { keep(std::make_exception_ptr(Error("cancelled", "a thread ended inside a callback"))); });
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
  void keep(const std::exception_ptr& thrown) {
    const std::lock_guard lock(mutex_);
    if (!exception_) exception_ = thrown;
    failed_.store(true, std::memory_order_relaxed);
  }

  std::mutex mutex_;
  std::exception_ptr exception_;
  std::atomic<bool> failed_{false};
};

}  // namespace orbicube::base

#include "base/threads/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <system_error>
#include <thread>
#include <vector>

#include "base/threads/cancellation.h"
#include "base/threads/first_exception.h"

namespace orbicube::base {
namespace {

// How often a thread looks before it sleeps: some tens of microseconds.
constexpr int patience = 4000;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

}  // namespace

struct ThreadPool::Shared {
  const Host* host;

  // The loop at hand. Written by the caller while `open` is false and `active` is zero.
  const void* body = nullptr;
  Call call = nullptr;
  std::size_t count = 0;
  std::atomic<std::size_t> next{0};

  std::atomic<bool> open{false};         // threads may join the loop
  std::atomic<std::uint32_t> active{0};  // threads inside of it
  std::atomic<std::uint32_t> loops{0};   // counts loops, for those who wait for the next
  std::atomic<bool> ending{false};
  FirstException first;
  std::vector<std::jthread> threads;

  void work() {
    for (std::size_t i; !first.failed() && (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) {
      first.guard([&] { call(body, i); });
    }
  }

  void serve() {
    std::uint32_t seen = 0;
    while (true) {
      for (int look = 0; loops.load() == seen && look < patience; ++look)
        pause();
      loops.wait(seen);
      seen = loops.load();
      if (ending.load()) return;
      // Either the caller sees this thread in `active`, or this thread sees that the loop is over.
      const Inside inside(active);
      if (open.load()) work();
    }
  }

  // A thread inside of the loop, also when it ends there.
  struct Inside {
    explicit Inside(std::atomic<std::uint32_t>& counter) : active(counter) { active.fetch_add(1); }
    ~Inside() {
      active.fetch_sub(1);
      active.notify_one();
    }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    std::atomic<std::uint32_t>& active;
  };

  // The loop, until all have left it; also when the caller's thread ends there.
  struct Loop {
    explicit Loop(Shared& pool) : shared(pool) {
      shared.open.store(true);
      shared.loops.fetch_add(1);
      shared.loops.notify_all();
    }
    ~Loop() {
      shared.open.store(false);
      shared.wait_for_threads();
    }
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;
    Shared& shared;
  };

  void wait_for_threads() {
    for (int look = 0; active.load() != 0 && look < patience; ++look)
      pause();
    for (std::uint32_t n; (n = active.load()) != 0;)
      active.wait(n);
  }
};

ThreadPool::ThreadPool(const Host& host) : shared_(std::make_unique<Shared>()) {
  shared_->host = &host;
  if (host.executor) return;
  const unsigned cores = host.thread_count != 0 ? host.thread_count : std::max(1u, std::thread::hardware_concurrency());
  shared_->threads.reserve(cores - 1);
  for (unsigned i = 1; i < cores; ++i) {
    try {
      shared_->threads.emplace_back([shared = shared_.get()] { shared->serve(); });
    } catch (const std::system_error&) {
      break;
    }
  }
}

ThreadPool::~ThreadPool() {
  const CancellationOff off;
  shared_->ending.store(true);
  shared_->loops.fetch_add(1);
  shared_->loops.notify_all();
  shared_.reset();  // joins
}

void ThreadPool::run(std::size_t count, const void* body, Call call) const {
  Shared& s = *shared_;
  if (s.host->executor) {
    s.host->parallel_for(count, [&](std::size_t i) { call(body, i); });
    return;
  }
  if (s.threads.empty()) {
    for (std::size_t i = 0; i < count; ++i)
      call(body, i);
    return;
  }
  s.body = body;
  s.call = call;
  s.count = count;
  s.next.store(0);
  {
    const Shared::Loop loop(s);
    s.work();
  }
  s.first.rethrow();
}

}  // namespace orbicube::base

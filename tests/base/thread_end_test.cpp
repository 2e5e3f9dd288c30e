// A thread that ends inside of what it was given to do: in a callback of the host, by pthread_exit or pthread_cancel.
#include <pthread.h>

#include <doctest/doctest.h>
#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "base/catch_all.h"
#include "base/error.h"
#include "base/threads/parallel.h"
#include "base/threads/thread_pool.h"

using namespace orbicube::base;

namespace {

// Runs `body` in a thread that may end inside of it; whether it came to its end.
bool came_to_its_end(const std::function<void()>& body) {
  struct Work {
    const std::function<void()>& body;
    bool done = false;
  } work{body};
  pthread_t thread{};
  const auto run = [](void* given) -> void* {
    auto& w = *static_cast<Work*>(given);
    w.body();
    w.done = true;
    return nullptr;
  };
  REQUIRE(pthread_create(&thread, nullptr, run, &work) == 0);
  REQUIRE(pthread_join(thread, nullptr) == 0);
  return work.done;
}

struct Noted {
  bool& destroyed;
  ~Noted() { destroyed = true; }
};

}  // namespace

TEST_CASE("catch_all catches everything but the end of the thread, which runs destructors") {
  CHECK(catch_all([]() -> int { throw 7; }, [] { return 1; }) == 1);
  CHECK(catch_all([] { return 2; }, [] { return 1; }) == 2);
  bool handled = false, told = false, destroyed = false;
  CHECK_FALSE(came_to_its_end([&] {
    const Noted noted{destroyed};
    catch_all([] { pthread_exit(nullptr); }, [&] { handled = true; }, [&] { told = true; });
  }));
  CHECK_FALSE(handled);
  CHECK(told);
  CHECK(destroyed);
}

TEST_CASE("a caller that ends in a piece of a loop waits for the other threads before its stack goes") {
  for (int round = 0; round < 20; ++round) {
    for (const bool by_cancel : {false, true}) {
      const auto ends_here = [&](const std::thread::id caller) {
        if (std::this_thread::get_id() != caller) return;
        if (!by_cancel) pthread_exit(nullptr);
        pthread_cancel(pthread_self());
        pthread_testcancel();
      };
      std::atomic<int> inside{0};
      bool left_alone = true;
      // The others wait for the caller to take a piece: else they might have done them all before its turn.
      std::atomic<bool> caller_began{false};
      const auto piece = [&](const std::thread::id caller) {
        ++inside;
        if (std::this_thread::get_id() == caller) caller_began = true;
        while (!caller_began)
          std::this_thread::yield();
        ends_here(caller);
        std::this_thread::yield();
        --inside;
      };
      CHECK_FALSE(came_to_its_end([&] {
        struct Last {
          std::atomic<int>& inside;
          bool& left_alone;
          ~Last() { left_alone = inside == 1; }  // the caller's own piece has not ended
        } const last{inside, left_alone};
        const auto caller = std::this_thread::get_id();
        parallel_for({}, 3, 1000, [&](std::size_t) { piece(caller); });
      }));
      CHECK(left_alone);
      inside = 0;
      caller_began = false;
      CHECK_FALSE(came_to_its_end([&] {
        Host host;
        host.thread_count = 3;
        const ThreadPool pool(host);
        const auto caller = std::this_thread::get_id();
        pool.run(1000, [&](std::size_t) { piece(caller); });
      }));
      CHECK(inside == 1);
    }
  }
}

TEST_CASE("a loop whose own thread ended in a piece is cancelled, and the pool goes on without it") {
  const auto caller = std::this_thread::get_id();
  const auto piece = [&](std::size_t) {
    if (std::this_thread::get_id() != caller) pthread_exit(nullptr);
    std::this_thread::yield();
  };
  for (int round = 0; round < 20; ++round) {
    try {
      parallel_for({}, 2, 100000, piece);
    } catch (const Error& error) {
      CHECK(std::string(error.kind()) == "cancelled");
    }
    Host host;
    host.thread_count = 2;
    const ThreadPool pool(host);
    bool cancelled = false;
    for (int loop = 0; loop < 100000 && !cancelled; ++loop) {
      try {
        pool.run(100, piece);
      } catch (const Error& error) {
        cancelled = std::string(error.kind()) == "cancelled";
      }
    }
    CHECK(cancelled);
    std::atomic<int> runs{0};
    pool.run(20, [&](std::size_t) { ++runs; });
    CHECK(runs == 20);
  }
}

#include "base/threads/thread_pool.h"

#include <doctest/doctest.h>
#include <atomic>
#include <stdexcept>
#include <vector>

using namespace orbicube::base;

namespace {

Host host_of(unsigned threads) {
  Host host;
  host.thread_count = threads;
  return host;
}

}  // namespace

TEST_CASE("every piece of every loop of a pool runs exactly once") {
  for (const unsigned threads : {1U, 2U, 5U}) {
    const Host host = host_of(threads);
    const ThreadPool pool(host);
    for (std::size_t loop = 0; loop < 2000; ++loop) {
      const std::size_t count = loop % 7;
      std::vector<std::atomic<int>> runs(count);
      pool.run(count, [&](std::size_t i) { ++runs[i]; });
      for (const auto& r : runs)
        REQUIRE(r == 1);
    }
  }
}

TEST_CASE("what one loop of a pool writes the next one reads on any thread") {
  const Host host = host_of(3);
  const ThreadPool pool(host);
  std::vector<int> value(64, 0);
  for (int loop = 0; loop < 500; ++loop) {
    std::vector<int> next(value.size());
    pool.run(value.size(), [&](std::size_t i) { next[i] = value[(i + 1) % value.size()] + 1; });
    value = next;
  }
  for (const int v : value)
    CHECK(v == 500);
}

TEST_CASE("pieces of a pool cover the whole range without overlap") {
  const Host host = host_of(2);
  const ThreadPool pool(host);
  for (const std::size_t total : {0U, 1U, 99U, 100U, 101U}) {
    std::vector<std::atomic<int>> runs(total);
    pool.run_pieces(total, 10, [&](std::size_t begin, std::size_t end) {
      CHECK(end - begin <= 10);
      for (std::size_t i = begin; i < end; ++i)
        ++runs[i];
    });
    for (const auto& r : runs)
      CHECK(r == 1);
  }
}

TEST_CASE("an exception of a pool's piece reaches the caller, and the pool goes on") {
  for (const unsigned threads : {1U, 3U}) {
    const Host host = host_of(threads);
    const ThreadPool pool(host);
    for (int loop = 0; loop < 50; ++loop) {
      CHECK_THROWS_WITH(pool.run(20,
                                 [](std::size_t i) {
                                   if (i == 5) throw std::runtime_error("piece 5");
                                 }),
                        "piece 5");
      std::atomic<int> runs{0};
      pool.run(20, [&](std::size_t) { ++runs; });
      CHECK(runs == 20);
    }
  }
}

TEST_CASE("a pool on a host's executor runs there") {
  Host host;
  std::size_t asked = 0;
  host.executor = [&](std::size_t count, const std::function<void(std::size_t)>& task) {
    asked += count;
    for (std::size_t i = count; i-- > 0;)
      task(i);
  };
  const ThreadPool pool(host);
  std::vector<std::size_t> order;
  pool.run(3, [&](std::size_t i) { order.push_back(i); });
  CHECK(asked == 3);
  CHECK(order == std::vector<std::size_t>{2, 1, 0});
}

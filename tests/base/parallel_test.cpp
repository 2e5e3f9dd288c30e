#include "base/threads/parallel.h"

#include <doctest/doctest.h>
#include <atomic>
#include <stdexcept>
#include <vector>

using namespace orbicube::base;

TEST_CASE("every piece runs exactly once, for any number of threads") {
  for (const unsigned threads : {0U, 1U, 2U, 7U}) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<std::atomic<int>> runs(count);
      parallel_for({}, threads, count, [&](std::size_t i) { ++runs[i]; });
      for (const auto& r : runs)
        CHECK(r == 1);
    }
  }
}

TEST_CASE("a host's executor is used") {
  std::size_t asked = 0;
  const Executor backwards = [&](std::size_t count, const std::function<void(std::size_t)>& task) {
    asked = count;
    for (std::size_t i = count; i-- > 0;)
      task(i);
  };
  std::vector<std::size_t> order;
  parallel_for(backwards, 1, 3, [&](std::size_t i) { order.push_back(i); });
  CHECK(asked == 3);
  CHECK(order == std::vector<std::size_t>{2, 1, 0});
}

TEST_CASE("an exception in a piece reaches the caller, also through an executor") {
  const auto body = [](std::size_t i) {
    if (i == 5) throw std::runtime_error("piece 5");
  };
  CHECK_THROWS_WITH(parallel_for({}, 3, 100, body), "piece 5");
  const Executor plain = [](std::size_t count, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = 0; i < count; ++i)
      task(i);
  };
  CHECK_THROWS_WITH(parallel_for(plain, 1, 100, body), "piece 5");
}

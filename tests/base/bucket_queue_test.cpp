#include "base/bucket_queue.h"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using namespace orbicube;

namespace {

template <std::size_t buckets>
std::vector<std::uint32_t> emptied(base::BucketQueue<buckets>& queue) {
  std::vector<std::uint32_t> order;
  while (!queue.empty()) {
    order.push_back(queue.front());
    CHECK(queue.pop() == order.back());
  }
  return order;
}

}  // namespace

TEST_CASE("The queue gives the highest power of two first, like ones in the order in which they came") {
  base::BucketQueue<2048> queue(8, std::pmr::get_default_resource());
  CHECK(queue.empty());
  queue.start(0x1p1023);
  queue.raise(0, 1.1);
  queue.raise(1, 2);
  queue.raise(2, 1e-300);
  queue.raise(3, 1e300);
  queue.raise(4, 0);
  queue.raise(5, 3);
  queue.raise(5, 0.5);  // not moved back
  queue.raise(2, 4);    // moved ahead, after 5
  queue.raise(6, std::numeric_limits<double>::infinity());
  CHECK(emptied(queue) == std::vector<std::uint32_t>{6, 3, 5, 2, 0, 1, 4});
  queue.raise(7, 1e-310);
  CHECK(queue.pop() == 7);
  CHECK(queue.empty());
}

TEST_CASE("Priorities are counted from the unit down to as many powers of two as there are") {
  base::BucketQueue<4> queue(6, std::pmr::get_default_resource());
  queue.raise(0, 1);
  queue.start(8);
  CHECK(queue.empty());
  queue.raise(0, 0.5);  // all these are up to 8 / 2^2
  queue.raise(1, 1e-320);
  queue.raise(2, 1);
  queue.raise(3, 8);
  queue.raise(4, 9);
  queue.raise(5, 1e300);  // as high as 9
  CHECK(emptied(queue) == std::vector<std::uint32_t>{4, 5, 3, 0, 1, 2});
}

TEST_CASE("A number that is fixed stays out until it is released") {
  base::BucketQueue<64> queue(3, std::pmr::get_default_resource());
  for (std::uint32_t item = 0; item < 3; ++item)
    queue.raise(item, 1);
  queue.hold(1);
  queue.raise(1, 5);
  CHECK(emptied(queue) == std::vector<std::uint32_t>{0, 2});
  queue.release(1);
  queue.raise(1, 0.1);
  CHECK(queue.pop() == 1);
}

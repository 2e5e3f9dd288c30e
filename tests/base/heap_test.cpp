#include "base/heap.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <set>
#include <vector>

#include "base/random.h"

using namespace orbicube;

namespace {

struct Entry {
  int priority, number;
  bool operator>(const Entry& other) const { return priority > other.priority; }
  bool operator==(const Entry&) const = default;
};

}  // namespace

TEST_CASE("Entries leave in order while others come") {
  base::Random random(1);
  base::Heap<int> heap(std::pmr::get_default_resource());
  std::multiset<int> expected;
  for (int round = 0; round < 20000; ++round) {
    if (expected.empty() || random.below(5) < 3) {
      const int entry = static_cast<int>(random.below(1000));
      heap.push(entry);
      expected.insert(entry);
    } else {
      CHECK(heap.top() == *expected.begin());
      CHECK(heap.pop() == *expected.begin());
      expected.erase(expected.begin());
    }
    REQUIRE(heap.size() == expected.size());
    REQUIRE(heap.empty() == expected.empty());
  }
  heap.clear();
  CHECK(heap.empty());
}

TEST_CASE("Equal entries leave in the order of the standard's priority queue") {
  base::Random random(2);
  base::Heap<Entry> heap(std::pmr::get_default_resource());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> expected;
  for (int i = 0; i < 3000; ++i) {
    const Entry entry{static_cast<int>(random.below(10)), i};
    heap.push(entry);
    expected.push(entry);
    if (random.below(3) == 0) {
      CHECK(heap.pop() == expected.top());
      expected.pop();
    }
  }
  for (; !heap.empty(); expected.pop())
    CHECK(heap.pop() == expected.top());
  CHECK(expected.empty());
}

TEST_CASE("A heap that is filled at once gives the largest first where that is the order") {
  base::Random random(3);
  base::Array<std::size_t> entries(500, std::pmr::get_default_resource());
  for (std::size_t& entry : entries)
    entry = random.below(100);
  base::Array<std::size_t> sorted = entries;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  base::Heap<std::size_t, std::less<>> heap(std::pmr::get_default_resource());
  heap.push(7);
  heap.assign(entries);
  for (const std::size_t entry : sorted)
    CHECK(heap.pop() == entry);
  CHECK(heap.empty());
}

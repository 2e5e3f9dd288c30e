#include "base/grouping.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/random.h"

using namespace orbicube;

namespace {

using Pair = std::pair<std::uint32_t, int>;  // key and item

std::vector<Pair> pairs_of(std::size_t count, std::size_t keys) {
  base::Random random(count + keys);
  std::vector<Pair> pairs(count);
  for (std::size_t i = 0; i < count; ++i)
    pairs[i] = {static_cast<std::uint32_t>(random.below(keys)), static_cast<int>(i)};
  return pairs;
}

}  // namespace

TEST_CASE("Groups beside each other are a stable sort by key") {
  for (const auto& [count, keys] : {std::pair{0, 3}, {1, 1}, {50, 200}, {3000, 17}, {3000, 1}}) {
    const std::vector<Pair> pairs = pairs_of(static_cast<std::size_t>(count), static_cast<std::size_t>(keys));
    const base::Groups<int> groups(
        static_cast<std::size_t>(keys),
        [&](const auto& visit) {
          for (const auto& [key, item] : pairs)
            visit(key, item);
        },
        std::pmr::get_default_resource());
    std::vector<Pair> sorted = pairs;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Pair& a, const Pair& b) { return a.first < b.first; });
    std::vector<Pair> found;
    for (std::size_t key = 0; key < groups.keys(); ++key) {
      CHECK(groups.begin(key) == found.size());
      CHECK(groups[key].size() == groups.size(key));
      for (const int item : groups[key])
        found.push_back({static_cast<std::uint32_t>(key), item});
    }
    CHECK(groups.keys() == static_cast<std::size_t>(keys));
    CHECK(found == sorted);
    CHECK(groups.all().size() == sorted.size());
  }
}

TEST_CASE("Groups can be filled again, and items be changed") {
  base::Groups<std::string, std::uint32_t> groups(std::pmr::get_default_resource());
  CHECK(groups.keys() == 0);
  CHECK(groups.all().empty());
  groups.assign(5, [](const auto& visit) {
    for (int i = 0; i < 10; ++i)
      visit(i % 3, std::to_string(i));
  });
  groups.assign(3, [](const auto& visit) {
    visit(2, "a");
    visit(0, "b");
    visit(2, "c");
  });
  CHECK(groups.keys() == 3);
  CHECK(groups.size(0) == 1);
  CHECK(groups[1].empty());
  std::swap(groups[2][0], groups[2][1]);
  CHECK(std::as_const(groups)[2][0] == "c");
  CHECK(groups.all()[2] == "a");
}

TEST_CASE("Items in the caller's arrays take their positions in the order of the visits") {
  const std::vector<Pair> pairs = pairs_of(500, 40);
  std::vector<int> begin(41, -1), items, doubled;
  int room = -1;
  base::group_by_key(
      std::span(begin),
      [&](const auto& visit) {
        for (const auto& [key, item] : pairs)
          visit(key, item, 2 * item);
      },
      [&](int count) {
        room = count;
        items.resize(static_cast<std::size_t>(count));
        doubled.resize(items.size());
      },
      [&](int at, int item, int twice) {
        items[static_cast<std::size_t>(at)] = item;
        doubled[static_cast<std::size_t>(at)] = twice;
      });
  CHECK(room == 500);
  CHECK(begin.front() == 0);
  CHECK(begin.back() == 500);
  for (std::uint32_t key = 0; key < 40; ++key) {
    CHECK(begin[key + 1] - begin[key] ==
          std::count_if(pairs.begin(), pairs.end(), [&](const Pair& p) { return p.first == key; }));
    for (int i = begin[key]; i < begin[key + 1]; ++i) {
      const auto at = static_cast<std::size_t>(i);
      CHECK(pairs[static_cast<std::size_t>(items[at])].first == key);
      CHECK(doubled[at] == 2 * items[at]);
      if (i > begin[key]) CHECK(items[at - 1] < items[at]);
    }
  }
}

TEST_CASE("Each vertex has the cells around it") {
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {2, 1, 3}, {0, 2, 5}};
  const auto around =
      base::cells_around(std::span<const std::array<std::uint32_t, 3>>(triangles), 6, std::pmr::get_default_resource());
  const std::vector<std::vector<std::uint32_t>> expected = {{0, 2}, {0, 1}, {0, 1, 2}, {1}, {}, {2}};
  for (std::size_t v = 0; v < 6; ++v)
    CHECK(std::ranges::equal(around[v], expected[v]));
}

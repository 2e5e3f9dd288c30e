#include "mesh/formats/inp/inp_sets.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

namespace orbicube::mesh {
namespace {

constexpr int unnumbered = 3;  // the last rank

// Returns the number that the name ends with; a minus counts behind an underscore, since PART-1 is the first part.
std::optional<std::int64_t> number_at_end(std::string_view name) {
  std::size_t begin = name.size();
  while (begin > 0 && name[begin - 1] >= '0' && name[begin - 1] <= '9')
    --begin;
  if (begin == name.size()) return std::nullopt;
  if (begin >= 2 && name[begin - 1] == '-' && name[begin - 2] == '_') --begin;
  std::int64_t value = 0;
  const auto [end, problem] = std::from_chars(name.data() + begin, name.data() + name.size(), value);
  return problem == std::errc() ? std::optional(value) : std::nullopt;
}

int rank_of(std::string_view name) {
  if (!number_at_end(name)) return unnumbered;
  for (const std::string_view own : {inp_triangle_set, inp_quadrilateral_set, inp_tetrahedron_set, inp_hexahedron_set})
    if (name.starts_with(own)) return 0;
  return name.starts_with("PHYSICAL") ? 1 : 2;
}

bool is_face(InpShape shape) {
  return shape == InpShape::triangle || shape == InpShape::quadrilateral;
}

bool is_line(InpShape shape) {
  return shape == InpShape::line || shape == InpShape::passed_over;
}

}  // namespace

std::uint32_t InpSets::set_named(const std::string& name) {
  const auto [at, added] = places_.try_emplace(name, static_cast<std::uint32_t>(sets_.size()));
  if (added) {
    sets_.emplace_back().name = name;
    sets_.back().rank = rank_of(name);
    sets_.back().region = number_at_end(name).value_or(0);
  }
  return at->second;
}

// Calls use(set, element) for each element of a set. Returns false where sets overlap so often that a file of their
// size can only be meant to take long.
template <class Use>
bool InpSets::for_each_member(std::span<const std::uint64_t> numbers, const base::Host& host, const Use& use) const {
  constexpr std::size_t max_sets_of_an_element = 100, few = 1'000'000;
  for (std::size_t e = 0; e < blocks_.size(); ++e)
    if (blocks_[e] != none) use(blocks_[e], e);
  std::vector<std::uint32_t> order(numbers.size());
  for (std::size_t e = 0; e < order.size(); ++e)
    order[e] = static_cast<std::uint32_t>(e);
  std::ranges::sort(order, {}, [&](std::uint32_t e) { return std::pair(numbers[e], e); });
  std::size_t left = few + max_sets_of_an_element * numbers.size();
  for (std::uint32_t s = 0; s < sets_.size(); ++s) {
    for (const Range& range : sets_[s].ranges) {
      auto at = std::ranges::lower_bound(order, range.first, {}, [&](std::uint32_t e) { return numbers[e]; });
      for (; at != order.end() && numbers[*at] <= range.last; ++at) {
        if (--left == 0) return false;
        if (left % 65536 == 0) host.report("element sets", s, sets_.size());
        if ((numbers[*at] - range.first) % range.step == 0) use(s, *at);
      }
    }
  }
  return true;
}

std::vector<std::int64_t> InpSets::regions(std::span<const std::uint64_t> numbers, std::span<const InpShape> shapes,
                                           std::vector<std::string>& notes, const base::Host& host) {
  const bool counted = for_each_member(numbers, host, [&](std::uint32_t s, std::size_t e) {
    sets_[s].size += !is_line(shapes[e]);
    sets_[s].faces += is_face(shapes[e]);
  });
  if (!counted) {
    notes.emplace_back("element sets were left out, since they overlap too often");
    return {};
  }
  int rank = unnumbered;
  for (const Set& set : sets_)
    if (set.size > 0) rank = std::min(rank, set.rank);
  std::vector<std::uint32_t> set_of(numbers.size(), none);
  for_each_member(numbers, host, [&](std::uint32_t s, std::size_t e) {
    const Set& set = sets_[s];
    if (set.rank > rank || is_line(shapes[e])) return;
    std::uint32_t& best = set_of[e];
    if (best == none || std::pair(set.size, s) < std::pair(sets_[best].size, best)) best = s;
  });
  if (rank == unnumbered) {
    // One set for all faces and one for all cells: by type, as of programs without regions.
    std::set<std::uint32_t> of_faces, of_cells;
    for (std::size_t e = 0; e < set_of.size(); ++e)
      if (!is_line(shapes[e])) (is_face(shapes[e]) ? of_faces : of_cells).insert(set_of[e]);
    if (of_faces.size() < 2 && of_cells.size() < 2) return {};
  }
  if (rank > 0) number_in_order(set_of, notes);
  std::vector<std::int64_t> result(numbers.size());
  for (std::size_t e = 0; e < result.size(); ++e)
    result[e] = set_of[e] == none ? 0 : sets_[set_of[e]].region;
  return result;
}

// Numbers the sets by their order unless the number of each is another's, of faces or of cells.
void InpSets::number_in_order(std::span<const std::uint32_t> set_of, std::vector<std::string>& notes) {
  constexpr std::size_t max_names = 10;
  const std::set<std::uint32_t> used(set_of.begin(), set_of.end());
  std::set<std::pair<std::int64_t, bool>> known;
  bool distinct = true;
  for (const std::uint32_t s : used) {
    if (s == none) continue;
    const Set& set = sets_[s];
    distinct = distinct && set.rank < unnumbered;
    if (set.faces > 0) distinct = known.insert({set.region, true}).second && distinct;
    if (set.faces < set.size) distinct = known.insert({set.region, false}).second && distinct;
  }
  if (distinct) return;
  std::string text;
  std::int64_t number = 0;
  for (const std::uint32_t s : used) {
    if (s == none) continue;
    sets_[s].region = ++number;
    if (static_cast<std::size_t>(number) <= max_names)
      text += (text.empty() ? "" : ", ") + sets_[s].name + " " + std::to_string(number);
  }
  if (static_cast<std::size_t>(number) > max_names) text += " and so on";
  notes.push_back("element sets were numbered as regions: " + text);
}

}  // namespace orbicube::mesh

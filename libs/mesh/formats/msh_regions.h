// Regions of Gmsh elements: their physical groups, which version 2 gives to elements and version 4 to the geometric
// entities that elements are on; or these entities, where a file has no groups.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace orbicube::mesh {

class MshRegions {
 public:
  // Returns a number for elements of this dimension, entity and group (0: none, or that of the entity). The same for
  // the same ones, from 0.
  std::int32_t place_of(int dimension, std::int64_t entity, std::int64_t group) {
    const auto [at, added] = places_.try_emplace({dimension, entity, group}, static_cast<std::int32_t>(places_.size()));
    return at->second;
  }

  // Version 4: an entity is in a group.
  void add_group(int dimension, std::int64_t entity, std::int64_t group) {
    const auto [at, added] = groups_.try_emplace({dimension, entity}, group);
    several_ += !added && at->second != group;
  }
  // Memberships of entities in further groups, which are passed over.
  std::size_t further_groups() const { return several_; }

  // Returns the regions by place: all empty where no face and no cell is in a group and all faces and all cells are on
  // one entity each, since that says nothing.
  std::vector<std::int64_t> regions() const {
    std::vector<std::int64_t> result(places_.size());
    bool grouped = false;
    std::array<std::size_t, 4> entities{};
    for (const auto& [key, place] : places_) {
      const auto& [dimension, entity, group] = key;
      grouped = grouped || group_of(key) != 0;
      ++entities[static_cast<std::size_t>(dimension)];
    }
    if (!grouped && entities[2] < 2 && entities[3] < 2) return {};
    for (const auto& [key, place] : places_)
      result[static_cast<std::size_t>(place)] = grouped ? group_of(key) : std::get<1>(key);
    return result;
  }

 private:
  using Key = std::tuple<int, std::int64_t, std::int64_t>;

  // Negative groups are those of reversed entities.
  std::int64_t group_of(const Key& key) const {
    std::int64_t group = std::get<2>(key);
    if (group == 0) {
      const auto at = groups_.find({std::get<0>(key), std::get<1>(key)});
      if (at != groups_.end()) group = at->second;
      return group < 0 && group != INT64_MIN ? -group : group;
    }
    return group;
  }

  std::map<Key, std::int32_t> places_;
  std::map<std::pair<int, std::int64_t>, std::int64_t> groups_;
  std::size_t several_ = 0;
};

}  // namespace orbicube::mesh

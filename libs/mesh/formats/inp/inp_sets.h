// Element sets of Abaqus and CalculiX as regions. These programs name sets, which may overlap, where regions have
// numbers: an element gets the number at the end of the name of its smallest set. Sets named as write_inp() names them
// come before others, then Gmsh's of physical groups, as PHYSICALVOLUME2, then others with a number, as PART-1; where
// no name has one, or two sets have the same, sets are numbered in their order from 1.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/host.h"
#include "mesh/formats/inp/inp_elements.h"

namespace orbicube::mesh {

// The beginnings of names of sets of write_inp(), which go on with the number of a region.
inline constexpr std::string_view inp_triangle_set = "TRIANGLES_";
inline constexpr std::string_view inp_quadrilateral_set = "QUADRILATERALS_";
inline constexpr std::string_view inp_tetrahedron_set = "TETRAHEDRA_";
inline constexpr std::string_view inp_hexahedron_set = "HEXAHEDRA_";

class InpSets {
 public:
  // ELSET of *ELEMENT, or "": the set of the elements that are added next.
  void begin_elements(const std::string& name) { block_ = name.empty() ? none : set_named(name); }
  void add_element() { blocks_.push_back(block_); }
  // *ELSET: the set that numbers from first to last are added to next.
  void begin_set(const std::string& name) { current_ = set_named(name); }
  void add(std::uint64_t first, std::uint64_t last, std::uint64_t step) {
    sets_[current_].ranges.push_back({first, last, step});
  }
  bool empty() const { return sets_.empty(); }

  // Returns a region for each element, by the numbers and shapes of elements; nothing where sets say nothing: one
  // without a number for all faces, and one for all cells. Adds a note where sets were numbered. O(n log n).
  std::vector<std::int64_t> regions(std::span<const std::uint64_t> numbers, std::span<const InpShape> shapes,
                                    std::vector<std::string>& notes, const base::Host& host);

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  struct Range {
    std::uint64_t first, last, step;
  };
  struct Set {
    std::string name;
    std::vector<Range> ranges;
    std::size_t size = 0;     // elements
    std::size_t faces = 0;    // of them
    int rank = 0;             // of the name; lower ones come before
    std::int64_t region = 0;  // by the name
  };

  std::uint32_t set_named(const std::string& name);
  template <class Use>
  bool for_each_member(std::span<const std::uint64_t> numbers, const base::Host& host, const Use& use) const;
  void number_in_order(std::span<const std::uint32_t> set_of, std::vector<std::string>& notes);

  std::vector<Set> sets_;
  std::map<std::string, std::uint32_t, std::less<>> places_;
  std::vector<std::uint32_t> blocks_;  // of each element
  std::uint32_t block_ = none, current_ = 0;
};

}  // namespace orbicube::mesh

#include "mesh/formats/vtk_data.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace orbicube::mesh {
namespace {

std::optional<std::uint64_t> number_of(std::string_view word) {
  std::uint64_t value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

class DataSearch {
 public:
  DataSearch(std::string_view text, std::optional<std::uint64_t> cells) : text_(text), cells_(cells) {}

  VtkData run() {
    while (at_ < text_.size()) {
      const std::string_view text = next_line();
      if (text.size() < 6 || text[0] < 'A' || text[0] > 'z') continue;
      const auto words = words_of(text.substr(0, 200));
      if (words.size() >= 2) line(words);
    }
    return std::move(result_);
  }

 private:
  std::string_view next_line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    return line;
  }

  void line(const std::vector<std::string_view>& words) {
    const std::string keyword = in_small_letters(words[0].substr(0, 20));
    if (keyword == "cell_data") {
      cells_ = number_of(words[1]);
    } else if (keyword == "point_data") {
      cells_.reset();
    } else if (words.size() < 3) {
      return;
    } else if (keyword == "field") {
      result_.arrays += std::min<std::uint64_t>(number_of(words[2]).value_or(0), 1000);
    } else if (keyword == "scalars") {
      ++result_.arrays;
      scalars(words);
    } else if (keyword == "vectors" || keyword == "normals" || keyword == "tensors" ||
               keyword == "texture_coordinates" || keyword == "color_scalars") {
      ++result_.arrays;
    } else if (words.size() == 4 && cells_ && words[1] == "1") {
      if (const auto count = number_of(words[2])) candidate(words[0], words[3], *count);
    }
  }

  // SCALARS name type components, and a line with the name of colors.
  void scalars(const std::vector<std::string_view>& words) {
    if (!cells_ || (words.size() > 3 && words[3] != "1")) return;
    const std::size_t before = at_;
    const auto table = words_of(next_line().substr(0, 200));
    if (table.size() == 2 && in_small_letters(table[0]) == "lookup_table")
      candidate(words[1], words[2], *cells_);
    else
      at_ = before;
  }

  void candidate(std::string_view name, std::string_view type, std::uint64_t count) {
    const auto rank = region_rank(name);
    const auto number = number_named(type);
    if (!rank || !number || (result_.regions && *rank >= rank_)) return;
    rank_ = *rank;
    result_.regions = VtkRegionArray{std::string(name), *number, count, at_};
  }

  std::string_view text_;
  std::optional<std::uint64_t> cells_;
  std::size_t at_ = 0, rank_ = 0;
  VtkData result_;
};

}  // namespace

std::optional<std::size_t> region_rank(std::string_view name) {
  // Ours, meshio's of MEDIT and Gmsh files, Gmsh's, and those of other programs.
  constexpr std::array names = {"region",     "medit:ref",   "gmsh:physical", "cellentityids",   "materialids",
                                "regionid",   "regionids",   "regions",       "region_id",       "material",
                                "materialid", "material_id", "cell_tags",     "gmsh:geometrical"};
  const auto found = std::ranges::find(names, in_small_letters(name.substr(0, 32)));
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

VtkData find_vtk_data(std::string_view text, std::optional<std::uint64_t> cells) {
  return DataSearch(text, cells).run();
}

}  // namespace orbicube::mesh

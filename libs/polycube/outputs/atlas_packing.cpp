#include "polycube/outputs/atlas_packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "polycube/outputs/patch_rectangles.h"

namespace orbicube::polycube {
namespace {

// Halvings of the interval of scales: to a thousandth of the scale.
constexpr int bisections = 10;
// Orders of patches that are tried at a scale. On polycubes of seven shapes, 8 cover up to 10 percent of the square
// more than one; 32 take four times as long, for 1.5 percent at one of them.
constexpr int max_orders = 8;
constexpr double smallest_fraction = 1e-3;  // of the largest scale, at which a search ends

PatchBox box_of(const PatchRectangle& rectangle, const std::array<Array<double>, 3>& layers) {
  const Array<double>&first = layers[first_axis(rectangle.label)], &second = layers[second_axis(rectangle.label)];
  const double a = first[rectangle.first], b = first[rectangle.first + 1];
  const bool positive = sign_of(rectangle.label) > 0;
  return {positive ? a : -b, second[rectangle.second], positive ? b : -a, second[rectangle.second + 1]};
}

// Cells of a square grid, a bit each; rows of whole words.
class Mask {
 public:
  Mask(std::size_t columns, std::size_t rows, std::pmr::memory_resource* memory)
      : columns_(columns), rows_(rows), words_((columns + 63) / 64), bits_(words_ * rows, 0, memory) {}

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  bool operator==(const Mask& other) const { return columns_ == other.columns_ && bits_ == other.bits_; }

  // Sets cells [left, right) of a row.
  void set(std::size_t row, std::size_t left, std::size_t right) {
    for (std::size_t column = left; column < right; ++column)
      bits_[row * words_ + column / 64] |= std::uint64_t{1} << (column % 64);
  }
  // Whether none of the cells of `other`, moved so, is set here.
  bool has_room(const Mask& other, std::size_t column, std::size_t row) const {
    for (std::size_t r = 0; r < other.rows_; ++r)
      for (std::size_t w = 0; w < other.words_; ++w)
        if ((window(row + r, column + 64 * w) & other.bits_[r * other.words_ + w]) != 0) return false;
    return true;
  }
  void add(const Mask& other, std::size_t column, std::size_t row) {
    for (std::size_t r = 0; r < other.rows_; ++r)
      for (std::size_t w = 0; w < other.words_; ++w) {
        const std::uint64_t bits = other.bits_[r * other.words_ + w];
        const std::size_t word = column / 64 + w, shift = column % 64;
        bits_[(row + r) * words_ + word] |= bits << shift;
        if (shift != 0 && word + 1 < words_) bits_[(row + r) * words_ + word + 1] |= bits >> (64 - shift);
      }
  }

 private:
  // The 64 cells of a row from a column on; none are set beyond the row.
  std::uint64_t window(std::size_t row, std::size_t column) const {
    const std::size_t word = column / 64, shift = column % 64;
    const std::uint64_t* const cells = bits_.data() + row * words_;
    const std::uint64_t low = word < words_ ? cells[word] >> shift : 0;
    return shift != 0 && word + 1 < words_ ? low | cells[word + 1] << (64 - shift) : low;
  }

  std::size_t columns_, rows_, words_;
  Array<std::uint64_t> bits_;
};

// A patch in one of its four directions, at one scale.
struct TurnedPatch {
  int quarter_turns;
  Mask mask;
};

class Packing {
 public:
  Packing(const PatchBoxes& boxes, const AtlasOptions& options, std::size_t cells, const base::Host& host)
      : boxes_(boxes),
        options_(options),
        host_(host),
        cells_(cells),
        cell_(static_cast<double>(options.size) / static_cast<double>(cells)),
        bounds_(host.memory),
        order_(host.memory) {
    for (Index p = 0; p < boxes.patches(); ++p)
      bounds_.push_back(bounds_of(boxes.of(p)));
    order_.resize(boxes.patches());
    std::iota(order_.begin(), order_.end(), Index{0});
    // The longest first, of equals the largest.
    const auto key = [&](Index p) { return std::tuple(-std::max(width(p), height(p)), -width(p) * height(p), p); };
    std::sort(order_.begin(), order_.end(), [&](Index a, Index b) { return key(a) < key(b); });
  }

  // Whether all patches found a place at this scale; then `places` has them. A patch without a place moves to half of
  // its position in the order, and all are placed again.
  bool pack(double scale, Array<AtlasPlace>& places) {
    Array<Array<TurnedPatch>> patches(host_.memory);
    for (Index p = 0; p < bounds_.size(); ++p)
      patches.push_back(turned_patches(p, scale));
    Array<Index> order(order_, host_.memory);
    for (int tries = 0; tries < max_orders; ++tries) {
      const std::size_t placed = place_all(patches, order, places);
      if (placed == order.size()) {
        order_ = order;
        return true;
      }
      const auto failed = order.begin() + static_cast<std::ptrdiff_t>(placed);
      std::rotate(order.begin() + static_cast<std::ptrdiff_t>(placed / 2), failed, failed + 1);
    }
    return false;
  }

  // A scale at which the longest patch is as long as the square, and none larger fits.
  double largest_scale() const {
    double longest = 0;
    for (Index p = 0; p < bounds_.size(); ++p)
      longest = std::max({longest, width(p), height(p)});
    return options_.size / longest;
  }

 private:
  double width(Index p) const { return bounds_[p].u_high - bounds_[p].u_low; }
  double height(Index p) const { return bounds_[p].v_high - bounds_[p].v_low; }

  // Each mask once: a rectangle has two, a square one; none where the patch is too large.
  Array<TurnedPatch> turned_patches(Index p, double scale) const {
    host_.report("packing", 0, 0);
    Array<TurnedPatch> result(host_.memory);
    for (const int turns : {0, 1, 2, 3}) {
      Mask mask = mask_of(p, scale, turns);
      const auto is_same = [&](const TurnedPatch& other) { return other.mask == mask; };
      if (mask.rows() > 0 && std::none_of(result.begin(), result.end(), is_same))
        result.push_back({turns, std::move(mask)});
    }
    return result;
  }

  // Of a patch with its margin, from the corner of the margin at the top left; no cells where it is too large.
  Mask mask_of(Index p, double scale, int turns) const {
    const auto end_cell = [&](double texels) { return static_cast<std::size_t>(std::ceil(texels / cell_)); };
    const bool upright = turns % 2 == 0;
    const double columns = std::ceil(((upright ? width(p) : height(p)) * scale + options_.padding) / cell_),
                 rows = std::ceil(((upright ? height(p) : width(p)) * scale + options_.padding) / cell_);
    if (columns > static_cast<double>(cells_) || rows > static_cast<double>(cells_)) return {0, 0, host_.memory};
    Mask mask(static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), host_.memory);
    AtlasPlace place = bounds_[p];
    place.quarter_turns = turns;
    for (const PatchBox& box : boxes_.of(p)) {
      const auto [x, y] = in_place(place, box.u_low, box.v_low);
      const auto [end_x, end_y] = in_place(place, box.u_high, box.v_high);
      const auto first_column = static_cast<std::size_t>(std::min(x, end_x) * scale / cell_);
      const std::size_t end_column = std::min(mask.columns(), end_cell(std::max(x, end_x) * scale + options_.padding)),
                        end_row = std::min(mask.rows(), end_cell(std::max(y, end_y) * scale + options_.padding));
      for (auto row = static_cast<std::size_t>(std::min(y, end_y) * scale / cell_); row < end_row; ++row)
        mask.set(row, first_column, end_column);
    }
    return mask;
  }

  // The number of patches that found a place before one that did not.
  std::size_t place_all(const Array<Array<TurnedPatch>>& patches, const Array<Index>& order,
                        Array<AtlasPlace>& places) const {
    Mask taken(cells_, cells_, host_.memory);
    Array<AtlasPlace> result(bounds_, host_.memory);
    for (std::size_t i = 0; i < order.size(); ++i)
      if (!place(patches[order[i]], taken, result[order[i]])) return i;
    places = std::move(result);
    return order.size();
  }

  // Where the patch ends nearest to the top, and there the most to the left.
  bool place(const Array<TurnedPatch>& patch, Mask& taken, AtlasPlace& result) const {
    for (std::size_t end_row = 1; end_row <= cells_; ++end_row) {
      if (end_row % 16 == 0) host_.report("packing", 0, 0);
      for (const auto& [turns, mask] : patch) {
        if (mask.rows() > end_row) continue;
        const std::size_t row = end_row - mask.rows();
        for (std::size_t column = 0; column + mask.columns() <= cells_; ++column) {
          if (!taken.has_room(mask, column, row)) continue;
          taken.add(mask, column, row);
          result.quarter_turns = turns;
          result.left = static_cast<double>(column) * cell_ + options_.padding / 2;
          result.top = static_cast<double>(row) * cell_ + options_.padding / 2;
          return true;
        }
      }
    }
    return false;
  }

  const PatchBoxes& boxes_;
  const AtlasOptions& options_;
  const base::Host& host_;
  std::size_t cells_;
  double cell_;  // texels
  Array<AtlasPlace> bounds_;
  Array<Index> order_;  // in which all patches fitted last
};

}  // namespace

PatchBoxes::PatchBoxes(const PatchGraph& graph, const base::Host& host) : begin(host.memory), boxes(host.memory) {
  const auto layers = layers_of(graph, host.memory);
  const Array<PatchRectangle> all = rectangles_of(graph, layers, host);
  begin.assign(graph.patches() + 1, 0);
  for (const PatchRectangle& r : all)
    ++begin[r.patch + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  boxes.resize(all.size());
  Array<Index> next(begin.begin(), begin.end() - 1, host.memory);
  for (const PatchRectangle& r : all)
    boxes[next[r.patch]++] = box_of(r, layers);
}

AtlasPlace bounds_of(std::span<const PatchBox> boxes) {
  AtlasPlace place;
  if (boxes.empty()) throw base::Error("invalid-argument", "a patch of the polycube has no area");
  place.u_low = place.v_low = std::numeric_limits<double>::infinity();
  place.u_high = place.v_high = -std::numeric_limits<double>::infinity();
  for (const PatchBox& box : boxes) {
    place.u_low = std::min(place.u_low, box.u_low);
    place.v_low = std::min(place.v_low, box.v_low);
    place.u_high = std::max(place.u_high, box.u_high);
    place.v_high = std::max(place.v_high, box.v_high);
  }
  return place;
}

std::array<double, 2> in_place(const AtlasPlace& place, double u, double v) {
  switch (place.quarter_turns) {
    case 1:
      return {place.v_high - v, place.u_high - u};
    case 2:
      return {place.u_high - u, v - place.v_low};
    case 3:
      return {v - place.v_low, u - place.u_low};
    default:
      return {u - place.u_low, place.v_high - v};
  }
}

bool pack_largest(const PatchBoxes& boxes, double high, std::size_t cells, Atlas& atlas, const base::Host& host) {
  Packing packing(boxes, atlas.options, cells, host);
  high = std::min(high, packing.largest_scale());
  double low = high;
  while (!packing.pack(low, atlas.places)) {
    high = low;
    low *= 0.75;
    if (low < smallest_fraction * packing.largest_scale()) return false;
  }
  for (int i = 0; i < bisections && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    (packing.pack(middle, atlas.places) ? low : high) = middle;
  }
  atlas.scale = low;
  return true;
}

}  // namespace orbicube::polycube

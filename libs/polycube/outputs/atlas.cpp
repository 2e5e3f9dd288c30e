#include "polycube/outputs/atlas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "polycube/outputs/patch_rectangles.h"

namespace orbicube::polycube {
namespace {

constexpr std::uint32_t max_size = 16384;
// Cells of the grid of masks along a side: a power of two from the first, where patches are few, to the last. Twice as
// many take up to four times as long, and waste half of a cell less around each patch.
constexpr std::size_t fewest_cells = 128, most_cells = 1024;
constexpr double cells_a_patch = 16;  // along a side of a patch of mean size
// Halvings of the interval of scales: to a thousandth of the scale.
constexpr int bisections = 10;

struct Box {
  double u_low, v_low, u_high, v_high;
};

// The rectangle in the plane of a patch, seen from outside: u to the right, v up.
Box box_of(const PatchRectangle& rectangle, const std::array<Array<double>, 3>& layers) {
  const Array<double>&first = layers[first_axis(rectangle.label)], &second = layers[second_axis(rectangle.label)];
  const double a = first[rectangle.first], b = first[rectangle.first + 1];
  const bool positive = sign_of(rectangle.label) > 0;
  return {positive ? a : -b, second[rectangle.second], positive ? b : -a, second[rectangle.second + 1]};
}

// The rectangles of the patches, patch by patch.
struct PatchBoxes {
  PatchBoxes(const PatchGraph& graph, const base::Host& host) : begin(host.memory), boxes(host.memory) {
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

  std::span<const Box> of(Index patch) const { return {boxes.data() + begin[patch], begin[patch + 1] - begin[patch]}; }
  std::size_t patches() const { return begin.size() - 1; }

  Array<Index> begin;
  Array<Box> boxes;
};

AtlasPlace bounds_of(std::span<const Box> boxes) {
  AtlasPlace place;
  if (boxes.empty()) throw base::Error("invalid-argument", "a patch of the polycube has no area");
  place.u_low = place.v_low = std::numeric_limits<double>::infinity();
  place.u_high = place.v_high = -std::numeric_limits<double>::infinity();
  for (const Box& box : boxes) {
    place.u_low = std::min(place.u_low, box.u_low);
    place.v_low = std::min(place.v_low, box.v_low);
    place.u_high = std::max(place.u_high, box.u_high);
    place.v_high = std::max(place.v_high, box.v_high);
  }
  return place;
}

// Cells of a square grid, a bit each; rows of whole words.
class Mask {
 public:
  Mask(std::size_t columns, std::size_t rows, std::pmr::memory_resource* memory)
      : columns_(columns), rows_(rows), words_((columns + 63) / 64), bits_(words_ * rows, 0, memory) {}

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }

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

  // Whether all patches found a place at this scale; then `places` has them.
  bool pack(double scale, Array<AtlasPlace>& places) const {
    Mask taken(cells_, cells_, host_.memory);
    Array<AtlasPlace> result(bounds_, host_.memory);
    for (const Index p : order_) {
      host_.report("packing", 0, 0);
      if (!place(p, scale, taken, result[p])) return false;
    }
    places = std::move(result);
    return true;
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

  // Of a patch with its margin, from the corner of the margin at the top left; no cells where it is too large.
  Mask mask_of(Index p, double scale, bool turned) const {
    const auto end_cell = [&](double texels) { return static_cast<std::size_t>(std::ceil(texels / cell_)); };
    const double across = turned ? height(p) : width(p), down = turned ? width(p) : height(p);
    const double columns = std::ceil((across * scale + options_.padding) / cell_),
                 rows = std::ceil((down * scale + options_.padding) / cell_);
    if (columns > static_cast<double>(cells_) || rows > static_cast<double>(cells_)) return {0, 0, host_.memory};
    Mask mask(static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), host_.memory);
    const AtlasPlace& all = bounds_[p];
    for (const Box& box : boxes_.of(p)) {
      const double left = turned ? all.v_high - box.v_high : box.u_low - all.u_low,
                   right = turned ? all.v_high - box.v_low : box.u_high - all.u_low,
                   top = turned ? all.u_high - box.u_high : all.v_high - box.v_high,
                   bottom = turned ? all.u_high - box.u_low : all.v_high - box.v_low;
      const auto first_column = static_cast<std::size_t>(left * scale / cell_);
      const std::size_t end_column = std::min(mask.columns(), end_cell(right * scale + options_.padding)),
                        end_row = std::min(mask.rows(), end_cell(bottom * scale + options_.padding));
      for (auto row = static_cast<std::size_t>(top * scale / cell_); row < end_row; ++row)
        mask.set(row, first_column, end_column);
    }
    return mask;
  }

  bool place(Index p, double scale, Mask& taken, AtlasPlace& result) const {
    const Mask upright = mask_of(p, scale, false), lying = mask_of(p, scale, true);
    for (std::size_t row = 0; row < cells_; ++row) {
      for (const Mask* mask : {&upright, &lying}) {
        if (mask->rows() == 0 || row + mask->rows() > cells_) continue;
        for (std::size_t column = 0; column + mask->columns() <= cells_; ++column) {
          if (!taken.has_room(*mask, column, row)) continue;
          taken.add(*mask, column, row);
          result.turned = mask == &lying;
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
  Array<Index> order_;
};

double area_of(const PatchBoxes& boxes) {
  double area = 0;
  for (const Box& box : boxes.boxes)
    area += (box.u_high - box.u_low) * (box.v_high - box.v_low);
  return area;
}

std::size_t first_cells(std::size_t patches) {
  const double wanted = cells_a_patch * std::sqrt(static_cast<double>(patches));
  std::size_t cells = fewest_cells;
  while (cells < most_cells && static_cast<double>(cells) < wanted)
    cells *= 2;
  return cells;
}

// The largest scale of a bisection, with its places; false where not even a thousandth of the square could be used.
bool pack_largest(const Packing& packing, double high, Atlas& atlas) {
  constexpr double smallest = 1e-3;
  double low = high;
  while (!packing.pack(low, atlas.places)) {
    high = low;
    low *= 0.75;
    if (low < smallest * packing.largest_scale()) return false;
  }
  for (int i = 0; i < bisections && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    (packing.pack(middle, atlas.places) ? low : high) = middle;
  }
  atlas.scale = low;
  return true;
}

}  // namespace

Atlas make_atlas(const PatchGraph& graph, const AtlasOptions& options, const base::Host& host) {
  if (options.size < 1 || options.size > max_size)
    throw base::Error("invalid-argument", "an atlas has from 1 to 16384 texels along a side");
  if (!std::isfinite(options.padding) || options.padding < 0)
    throw base::Error("invalid-argument", "the padding of an atlas is a number of at least 0");
  Atlas atlas(host.memory);
  atlas.options = options;
  const PatchBoxes boxes(graph, host);
  const double area = area_of(boxes), square = static_cast<double>(options.size) * options.size;
  for (std::size_t cells = first_cells(graph.patches()); cells <= most_cells; cells *= 2) {
    const Packing packing(boxes, options, cells, host);
    if (!pack_largest(packing, std::min(packing.largest_scale(), std::sqrt(square / area)), atlas)) continue;
    atlas.coverage = area * atlas.scale * atlas.scale / square;
    return atlas;
  }
  throw base::Error("unsupported", "an atlas of " + std::to_string(options.size) +
                                       " texels along a side is too small for " + std::to_string(graph.patches()) +
                                       " patches with their padding");
}

std::array<double, 2> texel_of(const Atlas& atlas, const PatchGraph& graph, Index patch, const Vector3& on_polycube) {
  const AtlasPlace& place = atlas.places[patch];
  const AxisLabel label = graph.labels[patch];
  const double u = sign_of(label) * on_polycube[static_cast<Eigen::Index>(first_axis(label))];
  const double v = on_polycube[static_cast<Eigen::Index>(second_axis(label))];
  if (place.turned)
    return {place.left + atlas.scale * (place.v_high - v), place.top + atlas.scale * (place.u_high - u)};
  return {place.left + atlas.scale * (u - place.u_low), place.top + atlas.scale * (place.v_high - v)};
}

}  // namespace orbicube::polycube

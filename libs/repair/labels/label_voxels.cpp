#include "repair/labels/label_voxels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "base/error.h"

namespace orbicube::repair {
namespace {

constexpr std::size_t padding = 2;
// The labels that a message lists.
constexpr std::size_t max_listed = 20;

using Counts = std::pmr::map<std::int32_t, std::size_t>;

[[noreturn]] void refuse(const std::string& message) {
  throw base::Error("invalid-argument", message);
}

void check(const LabelImage& image) {
  std::size_t count = 1;
  for (const std::size_t n : image.size) {
    if (n == 0) refuse("an image without voxels");
    if (n > std::numeric_limits<std::size_t>::max() / 64 / count) refuse("the sizes of the image overflow");
    count *= n;
  }
  if (count != image.labels.size())
    refuse("the image has " + std::to_string(image.labels.size()) + " labels, its sizes need " + std::to_string(count));
  for (std::size_t i = 0; i < 16; ++i) {
    if (!std::isfinite(image.to_world[i])) refuse("the map from voxels to the world has a number that is not finite");
    if (i >= 12 && image.to_world[i] != (i == 15 ? 1 : 0))
      refuse("the last row of the map from voxels to the world is not 0 0 0 1");
  }
}

Counts count_labels(const LabelImage& image, const base::Host& host) {
  Counts counts(host.memory);
  for (std::size_t i = 0; i < image.labels.size();) {
    const std::int32_t label = image.labels[i];
    const std::size_t end = std::min(image.labels.size(), i + 65536);
    std::size_t run = i;
    while (run < end && image.labels[run] == label)
      ++run;
    counts[label] += run - i;
    if (i / 4096 != run / 4096) host.report("labels", run, image.labels.size());
    i = run;
  }
  return counts;
}

std::string list_of(const Counts& counts) {
  std::string text;
  std::size_t listed = 0;
  for (const auto& [label, count] : counts) {
    if (label == 0) continue;
    if (listed++ == max_listed)
      return text + ", and " + std::to_string(counts.size() - counts.count(0) - max_listed) + " more";
    text += (text.empty() ? "" : ", ") + std::to_string(label) + " (" + std::to_string(count) +
            (count == 1 ? " voxel)" : " voxels)");
  }
  return text;
}

// The label, or the only one where it is 0.
std::int32_t chosen(const Counts& counts, std::int32_t label) {
  const std::size_t others = counts.size() - counts.count(0);
  if (others == 0) refuse("every voxel of the image has label 0, the background");
  if (label != 0) {
    if (counts.count(label) == 0)
      refuse("no voxel has label " + std::to_string(label) + "; there are labels " + list_of(counts));
    return label;
  }
  if (others > 1) refuse("no label is chosen and there are several: " + list_of(counts));
  return counts.begin()->first != 0 ? counts.begin()->first : std::next(counts.begin())->first;
}

}  // namespace

LabelVoxels voxels_of_label(const LabelImage& image, std::int32_t label, const base::Host& host) {
  check(image);
  const Counts counts = count_labels(image, host);
  label = chosen(counts, label);
  std::array<std::size_t, 3> first = image.size, last{};
  const auto for_each = [&](auto&& visit) {
    const std::int32_t* at = image.labels.data();
    for (std::size_t z = 0; z < image.size[2]; ++z) {
      for (std::size_t y = 0; y < image.size[1]; ++y, at += image.size[0]) {
        host.report("labels", z, image.size[2]);
        for (std::size_t x = 0; x < image.size[0]; ++x) {
          if (at[x] == label) visit(std::array{x, y, z});
        }
      }
    }
  };
  std::size_t border = 0;
  for_each([&](const std::array<std::size_t, 3>& p) {
    bool at_border = false;
    for (std::size_t a = 0; a < 3; ++a) {
      first[a] = std::min(first[a], p[a]);
      last[a] = std::max(last[a], p[a]);
      at_border = at_border || p[a] == 0 || p[a] + 1 == image.size[a];
    }
    border += at_border;
  });
  std::array<std::size_t, 3> size{};
  std::array<double, 3> origin{};
  for (std::size_t a = 0; a < 3; ++a) {
    size[a] = last[a] - first[a] + 1 + 2 * padding;
    origin[a] = static_cast<double>(first[a]) - static_cast<double>(padding);
  }
  LabelVoxels made{Voxels(size, host.memory), origin, label, counts.at(label), border};
  for_each([&](const std::array<std::size_t, 3>& p) {
    made.voxels.in[made.voxels.index(p[0] - first[0] + padding, p[1] - first[1] + padding, p[2] - first[2] + padding)] =
        1;
  });
  return made;
}

}  // namespace orbicube::repair

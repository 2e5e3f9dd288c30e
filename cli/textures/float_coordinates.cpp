#include "textures/float_coordinates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "mesh/search/predicates.h"

namespace orbicube::cli {
namespace {

constexpr int max_units = 16;  // in the last place: a thousandth of a texel of the largest atlas
constexpr int max_passes = 8;  // mended triangles seldom need more than two

class Mending {
 public:
  Mending(std::span<const mesh::Triangle> triangles, std::span<float> coordinates)
      : triangles_(triangles), coordinates_(coordinates) {}

  std::vector<std::size_t> lost() const {
    std::vector<std::size_t> found;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (is_lost(t)) found.push_back(t);
    return found;
  }

  // Tries the vertices of these triangles in turn.
  void mend(const std::vector<std::size_t>& lost) {
    std::map<mesh::Index, std::vector<std::size_t>> stars;
    for (const std::size_t t : lost)
      for (const mesh::Index v : triangles_[t])
        stars[v];
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const mesh::Index v : triangles_[t])
        if (const auto star = stars.find(v); star != stars.end()) star->second.push_back(t);
    for (const auto& [v, star] : stars)
      move(v, star, freedom_of(v, star));
  }

 private:
  Eigen::Vector2d at(mesh::Index v) const {
    const std::size_t i = 2 * std::size_t{v};
    return {coordinates_[i], -static_cast<double>(coordinates_[i + 1])};
  }
  bool is_lost(std::size_t t) const {
    return mesh::orientation_2d(at(triangles_[t][0]), at(triangles_[t][1]), at(triangles_[t][2])) <= 0;
  }
  std::size_t lost_of(const std::vector<std::size_t>& star) const {
    return static_cast<std::size_t>(std::count_if(star.begin(), star.end(), [&](std::size_t t) { return is_lost(t); }));
  }
  // Along which of the coordinates a vertex may move: inner ones along both, those on a side of a patch along that
  // side.
  std::array<bool, 2> freedom_of(mesh::Index v, const std::vector<std::size_t>& star) const {
    std::map<mesh::Index, int> neighbors;  // with the number of triangles at each
    for (const std::size_t t : star)
      for (const mesh::Index w : triangles_[t])
        if (w != v) ++neighbors[w];
    std::array<bool, 2> freedom = {true, true};
    for (const auto& [w, triangles] : neighbors)
      for (std::size_t k = 0; k < 2; ++k)
        if (triangles == 1 && coordinates_[2 * std::size_t{w} + 1 - k] != coordinates_[2 * std::size_t{v} + 1 - k])
          freedom[k] = false;
    return freedom;
  }

  // To the nearest place, in units in the last place, where the fewest triangles around the vertex are lost.
  void move(mesh::Index v, const std::vector<std::size_t>& star, const std::array<bool, 2>& freedom) {
    float* const place = coordinates_.data() + 2 * std::size_t{v};
    const std::array<float, 2> old = {place[0], place[1]};
    std::array<float, 2> best = old;
    std::size_t fewest = lost_of(star);
    for (int radius = 1; radius <= max_units && fewest > 0; ++radius) {
      for (int i = -radius; i <= radius; ++i) {
        for (int j = -radius; j <= radius; j += std::abs(i) == radius ? 1 : 2 * radius) {
          if ((i != 0 && !freedom[0]) || (j != 0 && !freedom[1])) continue;
          place[0] = moved(old[0], i);
          place[1] = moved(old[1], j);
          if (const std::size_t count = lost_of(star); count < fewest) {
            fewest = count;
            best = {place[0], place[1]};
          }
        }
      }
    }
    std::copy(best.begin(), best.end(), place);
  }
  static float moved(float value, int units) {
    const float unit = std::nextafter(value, std::numeric_limits<float>::infinity()) - value;
    return std::clamp(value + static_cast<float>(units) * unit, 0.0F, 1.0F);
  }

  std::span<const mesh::Triangle> triangles_;
  std::span<float> coordinates_;
};

}  // namespace

std::size_t mend_coordinates(std::span<const mesh::Triangle> triangles, std::span<float> coordinates) {
  Mending mending(triangles, coordinates);
  std::vector<std::size_t> lost = mending.lost();
  for (int pass = 0; pass < max_passes && !lost.empty(); ++pass) {
    const std::size_t before = lost.size();
    mending.mend(lost);
    lost = mending.lost();
    if (lost.size() == before) break;
  }
  return lost.size();
}

}  // namespace orbicube::cli

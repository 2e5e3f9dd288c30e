#include "untangle/tetrahedra/variables.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace orbicube::untangle {
namespace {

std::string place(std::size_t coordinate) {
  constexpr const char* axes[] = {"x", "y", "z"};
  return std::string(axes[coordinate % 3]) + " of vertex " + std::to_string(coordinate / 3);
}

// Coordinates that are one by their ties.
struct Group {
  double sum = 0;
  Index members = 0, variable = no_index, first_fixed = no_index;
};

// The coordinates of vertices, and which of them stay or are tied.
struct Coordinates {
  std::span<const Vector3> start;
  std::span<const std::uint8_t> fixed;
  std::span<const Index> ties;

  double value(std::size_t i) const { return start[i / 3][static_cast<Eigen::Index>(i % 3)]; }
  bool stays(std::size_t i) const { return !fixed.empty() && fixed[i] != 0; }
  Index group(std::size_t i) const { return ties.empty() ? no_index : ties[i]; }
};

// Fills the groups, and returns how many coordinates are free by themselves. Throws Error "invalid-argument".
std::size_t find_groups(const Coordinates& given, Array<Group>& groups) {
  const std::size_t count = 3 * given.start.size();
  std::size_t own = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(given.value(i))) throw base::Error("invalid-argument", "the start is not finite: " + place(i));
    const Index g = given.group(i);
    if (g == no_index) {
      own += !given.stays(i);
      continue;
    }
    if (g >= count)
      throw base::Error("invalid-argument", "a tie is not below three times the number of vertices: " + place(i));
    Group& of = groups[g];
    of.sum += given.value(i);
    ++of.members;
    if (!given.stays(i)) continue;
    if (of.first_fixed == no_index)
      of.first_fixed = static_cast<Index>(i);
    else if (given.value(of.first_fixed) != given.value(i))
      throw base::Error("invalid-argument", "two coordinates that are tied stay at different values: " +
                                                place(of.first_fixed) + " and " + place(i));
  }
  return own;
}

}  // namespace

Variables::Variables(std::span<const Vector3> start, std::span<const std::uint8_t> fixed, std::span<const Index> ties,
                     std::pmr::memory_resource* memory)
    : shared_(memory), flipped_(memory), variable_(3 * start.size(), no_index, memory), start_(memory) {
  const std::size_t count = variable_.size();
  base::require(count < no_index, "too many vertices");
  base::require(fixed.empty() || fixed.size() == count, "fixed needs three entries a vertex");
  base::require(ties.empty() || ties.size() == count, "ties need three entries a vertex");
  const Coordinates given{start, fixed, ties};
  Array<Group> groups(ties.empty() ? 0 : count, memory);
  own_ = find_groups(given, groups);
  std::size_t shared = 0;
  for (const Group& g : groups)
    shared += g.members > 0 && g.first_fixed == no_index;
  free_ = own_ + shared;
  start_.resize(free_);

  Index next_own = 0, next_shared = static_cast<Index>(own_);
  for (std::size_t i = 0; i < count; ++i) {
    const Index g = given.group(i);
    if (g == no_index) {
      variable_[i] = given.stays(i) ? static_cast<Index>(start_.size()) : next_own++;
      if (given.stays(i))
        start_.push_back(given.value(i));
      else
        start_[variable_[i]] = given.value(i);
      continue;
    }
    Group& of = groups[g];
    if (of.variable == no_index) {
      const bool held = of.first_fixed != no_index;
      of.variable = held ? static_cast<Index>(start_.size()) : next_shared++;
      if (held)
        start_.push_back(given.value(of.first_fixed));
      else
        start_[of.variable] = of.sum / of.members;
    }
    variable_[i] = of.variable;
  }
}

Variables::Variables(std::span<const Affine> coordinates, std::span<const double> start,
                     std::pmr::memory_resource* memory)
    : shared_(memory), flipped_(memory), variable_(coordinates.size(), no_index, memory), start_(memory) {
  Array<Index> uses(start.size(), 0, memory), number(start.size(), no_index, memory);
  for (const Affine& c : coordinates) {
    if (c.unknown != no_index) ++uses[c.unknown];
  }
  const auto own = [&](const Affine& c) { return c.unknown != no_index && uses[c.unknown] == 1; };
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const Affine& c = coordinates[i];
    if (!own(c)) continue;
    variable_[i] = static_cast<Index>(start_.size());
    start_.push_back(c.sign * start[c.unknown] + c.shift);
  }
  own_ = start_.size();
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const Affine& c = coordinates[i];
    if (c.unknown == no_index || own(c)) continue;
    if (number[c.unknown] == no_index) {
      number[c.unknown] = static_cast<Index>(start_.size());
      start_.push_back(start[c.unknown]);
    }
    variable_[i] = number[c.unknown];
    if (c.sign != 1 || c.shift != 0) shared_.push_back({static_cast<Index>(i), c.sign, c.shift});
    if (c.sign == 1) continue;
    if (flipped_.empty()) flipped_.resize(coordinates.size() / 3, 0);
    flipped_[i / 3] |= static_cast<std::uint8_t>(1U << i % 3);
  }
  free_ = start_.size();
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (coordinates[i].unknown != no_index) continue;
    variable_[i] = static_cast<Index>(start_.size());
    start_.push_back(coordinates[i].shift);
  }
}

void Variables::reduce(std::span<const Vector3> forces, std::span<double> sums) const {
  std::fill(sums.begin() + static_cast<std::ptrdiff_t>(own_), sums.end(), 0.0);
  for (std::size_t v = 0; v < forces.size(); ++v) {
    for (std::size_t a = 0; a < 3; ++a) {
      const Index i = variable_[3 * v + a];
      const double force = forces[v][static_cast<Eigen::Index>(a)];
      if (i < own_)
        sums[i] = force;
      else if (i < free_)
        sums[i] += is_flipped(v, a) ? -force : force;
    }
  }
}

}  // namespace orbicube::untangle

// Where two groups of shapes differ, or shapes change with a covariate: Hotelling's T2 of each point's position, or of
// its position along one direction, with p-values by permutation of the subjects' groups or covariates. Family-wise
// p-values compare with the maximum over points (Nichols and Holmes 2002), false-discovery rates are those of Benjamini
// and Hochberg (1995).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/host.h"
#include "correspondence/statistics/principal_modes.h"
#include "mesh/mesh.h"

namespace orbicube::correspondence {

struct GroupTestOptions {
  std::size_t permutations = 1000;  // besides the values as they are
  std::uint64_t seed = 1;
  // Empty: positions are tested. Otherwise a unit vector a point: positions along it are tested, so that with the
  // normals of the mean a shift of points along the surface is no difference.
  std::span<const mesh::Vector3> directions = {};
};

// One value a point.
struct GroupTest {
  std::vector<double> t2, p, p_family_wise, q;
  // 3 a point, along the directions if these are given: mean of group 1 minus mean of group 0, or slope of the
  // regression.
  std::vector<double> difference;
};

// Compares subjects of group 0 with those of group 1. Throws Error "invalid-argument" for a group of less than two or
// less than five subjects together, "cancelled". The same bits for any number of threads.
GroupTest compare_groups(const Population& subjects, std::span<const std::uint8_t> group,
                         const GroupTestOptions& options, const base::Host& host);

// Regresses each point's position on a value of each subject, and tests the slope: for values 0 and 1 these are the
// test and the difference of two groups. Throws Error "invalid-argument" for less than five subjects and values that
// are not finite or all equal, "cancelled". The same bits for any number of threads.
GroupTest regress(const Population& subjects, std::span<const double> covariate, const GroupTestOptions& options,
                  const base::Host& host);

// Returns the smallest false-discovery rate at which each p-value is a discovery.
std::vector<double> false_discovery_rates(std::span<const double> p);

}  // namespace orbicube::correspondence

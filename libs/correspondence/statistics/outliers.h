// Subjects that are far from the mean of their group, by distances whose spread outliers do not change.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "correspondence/statistics/principal_modes.h"

namespace orbicube::correspondence {

// Returns the root mean square distance of each subject's points from those of the mean.
std::vector<double> distances_from_mean(const Population& subjects, const Eigen::VectorXd& mean);

// Returns 1 for distances that are more than 3.5 robust standard deviations (1.4826 times the median absolute
// deviation) above the median, as Iglewicz and Hoaglin (1993) propose; none for less than five subjects.
std::vector<std::uint8_t> outliers(std::span<const double> distances);

}  // namespace orbicube::correspondence

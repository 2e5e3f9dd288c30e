// The peers that run in this process: NLopt's BOBYQA and NEWUOA, Powell's codes in C.
#pragma once

#include <functional>
#include <vector>

namespace orbicube::bench {

using Objective = std::function<double(const double* x)>;

bool has_nlopt();
// Runs to `radius_end` (its tolerance on x) or the budget; what f was is recorded by f.
void run_nlopt(bool newuoa, const std::vector<double>& start, const std::vector<double>& lower,
               const std::vector<double>& upper, double radius, std::size_t budget, const Objective& f);

}  // namespace orbicube::bench

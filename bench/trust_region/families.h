// The 22 residual families of More and Wild's benchmark, numbered as there.
#pragma once

#include <cstddef>
#include <vector>

namespace orbicube::bench {

void family_residuals(int family, std::size_t n, std::size_t m, const double* x, double* r);
std::vector<double> family_start(int family, std::size_t n);

}  // namespace orbicube::bench

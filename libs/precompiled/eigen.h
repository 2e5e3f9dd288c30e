// What nearly every file of a library on Eigen includes, read once where the option b_pch is on: reading it takes
// longer than what many of the files add. The build without it shows whether each file includes what it needs.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

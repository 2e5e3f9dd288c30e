// What nearly every file of a library on Eigen includes, read once a library: reading it takes longer than what many of
// the files add. A build with -Db_pch=false shows whether each file includes what it needs.
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

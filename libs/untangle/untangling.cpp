#include "untangle/untangling.h"

#include <cmath>

#include "base/counted.h"
#include "base/error.h"

namespace orbicube::untangle {

void require_valid(const UntangleOptions& options) {
  base::require(options.steps >= 0 && options.polish_steps >= 0, "numbers of steps must not be negative");
  base::require(options.volume_weight > 0 && std::isfinite(options.volume_weight),
                "the weight of volumes must be positive");
  base::require(options.tolerance >= 0 && options.tolerance < 1, "the tolerance must be at least 0 and below 1");
}

void require_untangled(const UntanglingFigures& figures, std::size_t count, const char* one, const char* many) {
  if (figures.inverted == 0) return;
  throw base::Error("no-valid-result", std::to_string(figures.inverted) + " of " + base::counted(count, one, many) +
                                           " inverted after " + base::counted(figures.steps, "step") +
                                           ", the first is " + std::to_string(figures.first_inverted));
}

}  // namespace orbicube::untangle

#include "hexmesh/captured/feature_figures.h"

#include <algorithm>
#include <cmath>

#include "mesh/topology/place_text.h"

namespace orbicube::hexmesh {
namespace {

std::string text_of(const MissingFeature& missing) {
  std::string text = missing.corner ? "corner " : "curve ";
  text += std::to_string(missing.number);
  text += missing.corner ? " at " : " from ";
  text += mesh::place_text(missing.from);
  if (!missing.corner)
    text += " to " + mesh::place_text(missing.to) + ", " +
            std::to_string(static_cast<int>(std::floor(100 * missing.captured))) + " % captured";
  return missing.why.empty() ? text : text + ": " + missing.why;
}

}  // namespace

std::size_t FeatureFigures::missing_curves() const {
  return static_cast<std::size_t>(
      std::count_if(missing.begin(), missing.end(), [](const MissingFeature& m) { return !m.corner; }));
}

std::string missing_text(const FeatureFigures& figures, std::size_t most) {
  if (figures.missing.empty()) return {};
  std::string text = std::to_string(figures.missing_curves()) + " of " + std::to_string(figures.curves) +
                     " curves and " + std::to_string(figures.missing_corners()) + " of " +
                     std::to_string(figures.corners) + " corners are missing";
  for (std::size_t i = 0; i < std::min(most, figures.missing.size()); ++i)
    text += "; " + text_of(figures.missing[i]);
  if (figures.missing.size() > most) text += "; ...";
  return text;
}

}  // namespace orbicube::hexmesh

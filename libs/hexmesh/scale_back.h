// Results of an input that was multiplied by 2^exponent to be of a size near 1, in the units of the caller.
#pragma once

#include "hexmesh/captured/feature_figures.h"
#include "hexmesh/strategies/hex_draft.h"

namespace orbicube::hexmesh {

void scale_back(FeatureFigures& figures, int exponent);
void scale_back(HexResult& result, int exponent);

}  // namespace orbicube::hexmesh

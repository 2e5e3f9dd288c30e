// The surface of a label of an image file.
#pragma once

#include "images/label_file.h"
#include "repair/labels/surface_of_labels.h"

namespace orbicube::cli {

// Extracts the surface as repair::surface_of_label(). Where a label must be chosen, the error names --label.
repair::LabelSurface extract_label(const LabelFile& file, const repair::LabelOptions& options, const base::Host& host);

}  // namespace orbicube::cli

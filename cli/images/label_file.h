// Label images of NIfTI, NRRD and MetaImage files.
#pragma once

#include <filesystem>
#include <string>

#include "images/image_header.h"
#include "repair/labels/surface_of_labels.h"
#include "session/session.h"

namespace orbicube::cli {

inline const std::string label_image_endings = ".nii .nii.gz .nrrd .nhdr .mha .mhd";

struct LabelFile {
  ImageHeader header;
  base::Array<std::int32_t> labels;
  repair::LabelImage image() const { return {labels, header.size, header.to_world}; }
};

// Reads an image, whose format goes by its ending. Voxels must have whole numbers within the range of int32. Throws
// Error "unsupported-format", "empty-file", those of the headers, "truncated" if there are fewer bytes than the sizes
// need, "unsupported" for values that are no labels, "io", "cancelled".
LabelFile read_labels(const std::filesystem::path& path, Session& session);

}  // namespace orbicube::cli

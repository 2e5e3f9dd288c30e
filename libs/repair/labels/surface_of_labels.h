// The closed surface of a label of an image, step by step, with figures of what each step did.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "repair/certificate.h"
#include "repair/types.h"

namespace orbicube::repair {

struct LabelImage {
  std::span<const std::int32_t> labels;  // x fastest
  std::array<std::size_t, 3> size;
  std::array<double, 16>
      to_world;  // 4x4, row-major: from (x, y, z, 1), voxel centers at whole numbers; the last row is 0 0 0 1
};

struct LabelOptions {
  std::int32_t label = 0;   // 0: the only one besides 0
  std::size_t keep = 1;     // parts connected through faces of voxels, the largest ones; 0: all
  bool cavities = false;    // kept, as surfaces inside
  bool handles = false;     // kept
  double smoothing = 1;     // standard deviation of the Gaussian, in voxels; 0: none
  double max_slide = 0.45;  // of a vertex from the middle between two voxel centers, in voxels, below 0.5
};

struct LabelReport {
  std::int32_t label = 0;
  std::size_t voxels = 0,
              border_voxels = 0;  // of the label; of these at the border of the image, where the surface is closed
  std::size_t found_parts = 0, kept_parts = 0, dropped_voxels = 0;
  std::size_t cavities = 0, filled_voxels = 0;
  std::size_t handles = 0, added_voxels = 0, removed_voxels = 0;  // handles and tunnels that were removed
  double largest_slide = 0;           // of a vertex from the middle between two voxel centers, in voxels
  std::size_t centered_vertices = 0;  // moved to the middle again, because triangles intersected
  Certificate certificate;
};

struct LabelSurface {
  explicit LabelSurface(std::pmr::memory_resource* memory) : positions(memory), triangles(memory) {}
  Array<Vector3> positions;
  Array<Triangle> triangles;
  LabelReport report;
};

// Extracts the surface of a label: its voxels are cropped, the largest parts kept, cavities filled, handles and tunnels
// removed at their thinnest places, and vertices slid along the edges between voxel centers to where the smoothed
// object ends. It is closed, oriented and manifold, has genus 0 unless handles are kept, and passes between the centers
// of the voxels of the object so made and all others, nowhere farther than half a voxel from the sides of its voxels.
// The same bits for any number of threads. O(n log n) of the voxels in the label's box. Throws Error "invalid-argument"
// (sizes, affine map, options, several labels and none chosen, a label that is not there), "no-valid-result" if
// triangles intersect, "cancelled".
LabelSurface surface_of_label(const LabelImage& image, const LabelOptions& options, const base::Host& host);

}  // namespace orbicube::repair

#include "repair/labels/extraction.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "repair/labels/cell_cases.h"

namespace orbicube::repair {
namespace {

// Goes through the cells, two layers of voxels at a time.
class Extraction {
 public:
  Extraction(const Voxels& voxels, const SmoothedVoxels& smoothed, double max_slide, const base::Host& host)
      : voxels_(voxels),
        smoothed_(smoothed),
        max_slide_(max_slide),
        host_(host),
        surface_(host.memory),
        lower_(3 * layer(), no_index, host.memory),
        upper_(3 * layer(), no_index, host.memory) {}

  VoxelSurface run() {
    for (std::size_t z = 0; z + 1 < voxels_.size[2]; ++z) {
      for (std::size_t y = 0; y + 1 < voxels_.size[1]; ++y) {
        host_.report("surface", z, voxels_.size[2]);
        pass_row(y, z);
      }
      std::swap(lower_, upper_);
      std::fill(upper_.begin(), upper_.end(), no_index);
    }
    return std::move(surface_);
  }

 private:
  std::size_t layer() const { return voxels_.size[0] * voxels_.size[1]; }

  void pass_row(std::size_t y, std::size_t z) {
    const VoxelIndex row = voxels_.index(0, y, z);
    const std::size_t sy = voxels_.size[0], sz = layer();
    const std::uint8_t* in = voxels_.in.data() + row;
    const auto column = [&](std::size_t x) {
      return static_cast<unsigned>(in[x] | in[x + sy] << 2 | in[x + sz] << 4 | in[x + sy + sz] << 6);
    };
    unsigned left = column(0);
    for (std::size_t x = 0; x + 1 < voxels_.size[0]; ++x) {
      const unsigned right = column(x + 1), corners = left | right << 1;
      left = right;
      if (corners != 0 && corners != 255) add_cell(row + x, static_cast<std::uint8_t>(corners));
    }
  }

  void add_cell(VoxelIndex cell, std::uint8_t corners) {
    const CellCase& made = cell_case(corners);
    for (std::size_t p = 0; p < made.patch_count; ++p) {
      const CellPatch& patch = made.patches[p];
      Index center = no_index;
      if (patch.has_center) {
        for (std::size_t i = 0; i < patch.loop_size; ++i)
          surface_.loop.push_back(vertex_on(cell, patch.loop[i]));
        center = add_vertex(surface_.loop_start.size() - 1, 3, 0);
        surface_.loop_start.push_back(surface_.loop.size());
      }
      for (std::size_t t = 0; t < patch.triangle_count; ++t) {
        Triangle triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint8_t e = patch.triangles[t][k];
          triangle[k] = e == center_vertex ? center : vertex_on(cell, e);
        }
        surface_.triangles.push_back(triangle);
      }
    }
  }

  Index vertex_on(VoxelIndex cell, std::uint8_t edge) {
    const auto corner = static_cast<std::size_t>(edge / 3), axis = static_cast<std::size_t>(edge % 3);
    const VoxelIndex v = cell + (corner & 1) + (corner >> 1 & 1) * voxels_.size[0] + (corner >> 2) * layer();
    Index& vertex = (corner >> 2 == 0 ? lower_ : upper_)[3 * (v % layer()) + axis];
    if (vertex == no_index)
      vertex =
          add_vertex(v, static_cast<std::uint8_t>(axis), smoothed_.crossing(v, static_cast<int>(axis), max_slide_));
    return vertex;
  }

  Index add_vertex(VoxelIndex voxel, std::uint8_t axis, double crossing) {
    if (surface_.crossing.size() >= no_index)
      throw base::Error("unsupported",
                        "the surface has more vertices than the largest index; choose a smaller part of the image");
    surface_.edge_voxel.push_back(voxel);
    surface_.edge_axis.push_back(axis);
    surface_.crossing.push_back(crossing);
    return static_cast<Index>(surface_.crossing.size() - 1);
  }

  const Voxels& voxels_;
  const SmoothedVoxels& smoothed_;
  double max_slide_;
  const base::Host& host_;
  VoxelSurface surface_;
  // The vertices on edges that start in the lower and the upper layer of voxels.
  Array<Index> lower_, upper_;
};

}  // namespace

VoxelSurface extract_surface(const Voxels& voxels, const SmoothedVoxels& smoothed, double max_slide,
                             const base::Host& host) {
  return Extraction(voxels, smoothed, max_slide, host).run();
}

Vector3 place_of(const VoxelSurface& surface, const Voxels& voxels, Index vertex) {
  const std::uint8_t axis = surface.edge_axis[vertex];
  if (axis < 3) {
    const auto p = voxels.place(surface.edge_voxel[vertex]);
    Vector3 place(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
    place[axis] += surface.crossing[vertex];
    return place;
  }
  const std::size_t loop = surface.edge_voxel[vertex];
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = surface.loop_start[loop]; i < surface.loop_start[loop + 1]; ++i)
    sum += place_of(surface, voxels, surface.loop[i]);
  return sum / static_cast<double>(surface.loop_start[loop + 1] - surface.loop_start[loop]);
}

}  // namespace orbicube::repair

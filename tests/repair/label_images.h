// Label images made by numbers: smooth blobs, curved tubes with noise, loose voxels, and handles of one voxel.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "mesh/mesh.h"
#include "repair/labels/label_voxels.h"
#include "repair/labels/surface_of_labels.h"
#include "repair/labels/voxel_topology.h"

namespace orbicube::test {

struct LabelVolume {
  std::array<std::size_t, 3> size{};
  std::vector<std::int32_t> labels;
  std::array<double, 16> to_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  explicit LabelVolume(std::size_t x, std::size_t y, std::size_t z) : size{x, y, z}, labels(x * y * z) {}
  std::int32_t& at(std::size_t x, std::size_t y, std::size_t z) { return labels[x + size[0] * (y + size[1] * z)]; }
  repair::LabelImage image() const { return {labels, size, to_world}; }

  // Sets the label where inside(x, y, z).
  template <class Inside>
  void fill(const Inside& inside) {
    for (std::size_t z = 0; z < size[2]; ++z) {
      for (std::size_t y = 0; y < size[1]; ++y) {
        for (std::size_t x = 0; x < size[0]; ++x) {
          if (inside(mesh::Vector3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z))))
            at(x, y, z) = 1;
        }
      }
    }
  }
};

// A level set of a few Gaussians.
inline LabelVolume blob(base::Random& random) {
  LabelVolume v(26, 24, 22);
  std::vector<mesh::Vector3> centers;
  for (int i = 0; i < 6; ++i)
    centers.emplace_back(5 + 15 * random.unit(), 5 + 13 * random.unit(), 5 + 11 * random.unit());
  v.fill([&](const mesh::Vector3& p) {
    double sum = 0;
    for (const mesh::Vector3& c : centers)
      sum += std::exp(-(p - c).squaredNorm() / 14);
    return sum > 0.4;
  });
  return v;
}

// Two curved horns that meet, with voxels at their walls flipped at random, holes and specks.
inline LabelVolume ventricle(base::Random& random) {
  LabelVolume v(34, 30, 20);
  const double bend = 0.5 + random.unit(), radius = 2.5 + 1.5 * random.unit();
  v.fill([&](const mesh::Vector3& p) {
    double nearest = 1e9;
    for (int i = 0; i <= 40; ++i) {
      const double s = i / 20.0 - 1;
      for (const double side : {-1.0, 1.0}) {
        const mesh::Vector3 c(17 + side * (2.5 + 8 * s * s), 15 + 11 * s, 10 + 6 * bend * (s * s - 0.5));
        nearest = std::min(nearest, (p - c).norm());
      }
    }
    const double chance = std::exp(-std::abs(nearest - radius));
    return (nearest < radius) != (random.unit() < 0.25 * chance);
  });
  return v;
}

// Loose voxels, which touch in every way.
inline LabelVolume loose_voxels(base::Random& random) {
  LabelVolume v(12, 11, 10);
  const double density = 0.3 + 0.5 * random.unit();
  v.fill([&](const mesh::Vector3&) { return random.unit() < density; });
  return v;
}

// A ball with arcs of one voxel's thickness on it and tunnels of one voxel's width through it.
inline LabelVolume handles(base::Random& random) {
  LabelVolume v(30, 30, 30);
  const mesh::Vector3 center(15, 15, 15);
  v.fill([&](const mesh::Vector3& p) { return (p - center).norm() < 8.3; });
  for (int arc = 0; arc < 3; ++arc) {
    const double from = 6 * random.unit(), tilt = 3 * random.unit();
    for (int i = 0; i <= 400; ++i) {
      const double a = from + i / 400.0, height = 8 + 5 * std::sin(3.14159265 * i / 400);
      const mesh::Vector3 p =
          center + height * mesh::Vector3(std::cos(a) * std::cos(tilt), std::sin(a), std::cos(a) * std::sin(tilt));
      v.at(static_cast<std::size_t>(std::lround(p[0])), static_cast<std::size_t>(std::lround(p[1])),
           static_cast<std::size_t>(std::lround(p[2]))) = 1;
    }
  }
  const std::size_t y = 11 + static_cast<std::size_t>(8 * random.unit()),
                    z = 11 + static_cast<std::size_t>(8 * random.unit());
  for (std::size_t x = 0; x < 30; ++x)
    v.at(x, y, z) = 0;
  return v;
}

// The object whose surface surface_of_label() extracts by default.
inline repair::LabelVoxels object_of(const LabelVolume& volume, const base::Host& host) {
  repair::LabelVoxels object = repair::voxels_of_label(volume.image(), 0, host);
  repair::VoxelPartFigures parts;
  repair::keep_voxel_parts(object.voxels, 1, parts, host);
  repair::fill_cavities(object.voxels, parts, host);
  repair::remove_handles(object.voxels, {1, 1, 1}, host);
  return object;
}

// The distance of a point (in voxels of the image) from the nearest side between a voxel of the object and one of the
// background, or 9 where none is within two voxels.
inline double distance_from_sides(const repair::LabelVoxels& object, const mesh::Vector3& in_image) {
  const repair::Voxels& voxels = object.voxels;
  double nearest = 9;
  mesh::Vector3 p = in_image;
  std::array<std::size_t, 3> first{}, last{};
  for (int a = 0; a < 3; ++a) {
    const auto k = static_cast<std::size_t>(a);
    p[a] -= object.origin[k];
    first[k] = static_cast<std::size_t>(std::max(0.0, std::floor(p[a]) - 1));
    last[k] = std::min(voxels.size[k] - 2, static_cast<std::size_t>(std::max(0.0, std::floor(p[a]) + 2)));
  }
  for (std::size_t z = first[2]; z <= last[2]; ++z) {
    for (std::size_t y = first[1]; y <= last[1]; ++y) {
      for (std::size_t x = first[0]; x <= last[0]; ++x) {
        const repair::VoxelIndex v = voxels.index(x, y, z);
        const mesh::Vector3 c(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
        for (int a = 0; a < 3; ++a) {
          if (voxels.in[v] == voxels.in[v + static_cast<std::size_t>(voxels.stride(a))]) continue;
          mesh::Vector3 d = (p - c).cwiseAbs() - mesh::Vector3::Constant(0.5);
          d = d.cwiseMax(0);
          d[a] = p[a] - c[a] - 0.5;
          nearest = std::min(nearest, d.norm());
        }
      }
    }
  }
  return nearest;
}

// The largest such distance of the vertices, the middles of edges and the centroids of a surface in voxels.
inline double largest_distance_from_sides(const repair::LabelVoxels& object, const repair::LabelSurface& surface) {
  double largest = 0;
  for (const mesh::Triangle& t : surface.triangles) {
    const mesh::Vector3 &a = surface.positions[t[0]], &b = surface.positions[t[1]], &c = surface.positions[t[2]];
    for (const mesh::Vector3& p :
         {a, mesh::Vector3((a + b) / 2), mesh::Vector3((b + c) / 2), mesh::Vector3((a + b + c) / 3)})
      largest = std::max(largest, distance_from_sides(object, p));
  }
  return largest;
}

}  // namespace orbicube::test

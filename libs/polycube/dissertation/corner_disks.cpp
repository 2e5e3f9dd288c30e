#include "polycube/dissertation/corner_disks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.h"
#include "linear/sparse_system.h"

namespace orbicube::polycube::dissertation {
namespace {

constexpr const char* corner_disks_phase = "corner disks";

class DiskMaker {
 public:
  DiskMaker(const EditableSurface& surface, Index center, const base::Host& host)
      : surface_(surface),
        center_(center),
        host_(host),
        place_(surface.vertices(), no_index, host.memory),
        loop_(host.memory) {}

  bool build(int rings, CornerDisk& disk) {
    host_.report(corner_disks_phase, 0, 0);
    collect(rings, disk);
    if (!find_outline(disk)) return false;
    disk.rings = rings;
    place_outline(disk);
    place_inside(disk);
    return true;
  }

 private:
  // Vertices at most `rings` edges away.
  void collect(int rings, CornerDisk& disk) {
    for (const Index v : disk.vertices)
      place_[v] = no_index;
    disk.vertices.assign(1, center_);
    place_[center_] = 0;
    std::size_t begin = 0;
    for (int ring = 0; ring < rings; ++ring) {
      const std::size_t end = disk.vertices.size();
      for (std::size_t i = begin; i < end; ++i) {
        surface_.for_each_outgoing(disk.vertices[i], [&](Index h) {
          const Index v = surface_.end(h);
          if (place_[v] != no_index) return;
          place_[v] = static_cast<Index>(disk.vertices.size());
          disk.vertices.push_back(v);
        });
      }
      begin = end;
    }
  }

  bool inside(Index half_edge) const {
    const Triangle& t = surface_.triangle[half_edge / 3];
    return place_[t[0]] != no_index && place_[t[1]] != no_index && place_[t[2]] != no_index;
  }

  // The one loop of half-edges of triangles inside whose opposites are not; false where there are none, several, or
  // more than a disk's inside.
  bool find_outline(const CornerDisk& disk) {
    loop_.clear();
    std::size_t outline = 0, half_edges = 0;
    Index first = no_index;
    for (const Index v : disk.vertices) {
      surface_.for_each_outgoing(v, [&](Index h) {
        if (!inside(h)) return;
        ++half_edges;
        if (inside(surface_.opposite(h))) return;
        ++outline;
        if (first == no_index) first = h;
      });
    }
    if (first == no_index) return false;
    Index h = first;
    do {
      loop_.push_back(h);
      Index out = EditableSurface::next(h);
      while (inside(surface_.opposite(out)))
        out = EditableSurface::next(surface_.opposite(out));
      h = out;
    } while (h != first && loop_.size() <= outline);
    const std::size_t faces = half_edges / 3, edges = (half_edges + outline) / 2;
    return loop_.size() == outline && disk.vertices.size() + faces == edges + 1;
  }

  void place_outline(CornerDisk& disk) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    disk.places.assign(disk.vertices.size(), {nothing, nothing});
    double whole = 0, length = 0;
    for (const Index h : loop_)
      whole += surface_.length(h);
    for (const Index h : loop_) {
      const double angle = 2 * std::numbers::pi * length / whole;
      disk.places[place_[surface_.start(h)]] = {std::cos(angle), std::sin(angle)};
      length += surface_.length(h);
    }
  }

  void place_inside(CornerDisk& disk) {
    Array<Index> unknown(disk.vertices.size(), no_index, host_.memory);
    Index count = 0;
    for (std::size_t i = 0; i < disk.vertices.size(); ++i) {
      if (std::isnan(disk.places[i].x())) unknown[i] = count++;
    }
    linear::Triplets triplets(host_.memory);
    const auto each_edge = [&](const auto& visit) {
      for (std::size_t i = 0; i < disk.vertices.size(); ++i) {
        if (unknown[i] == no_index) continue;
        surface_.for_each_outgoing(disk.vertices[i], [&](Index h) { visit(i, place_[surface_.end(h)]); });
      }
    };
    each_edge([&](std::size_t i, Index j) {
      if (unknown[j] != no_index && unknown[j] < unknown[i]) triplets.emplace_back(unknown[i], unknown[j], 0.0);
    });
    for (Index i = 0; i < count; ++i)
      triplets.emplace_back(i, i, 0.0);
    linear::SparseSystem system(count, triplets, linear::DirectMethod::eigen);
    std::fill_n(system.values(), system.value_count(), 0.0);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 2);
    each_edge([&](std::size_t i, Index j) {
      system.values()[system.place(unknown[i], unknown[i])] += 1;
      if (unknown[j] == no_index)
        right.row(unknown[i]) += disk.places[j].transpose();
      else if (unknown[j] < unknown[i])
        system.values()[system.place(unknown[i], unknown[j])] = -1;
    });
    if (!system.factorize()) throw base::Error("degenerate", "the disk around a corner point cannot be computed");
    const Eigen::VectorXd x = system.solve(right.col(0)), y = system.solve(right.col(1));
    for (std::size_t i = 0; i < disk.vertices.size(); ++i)
      if (unknown[i] != no_index) disk.places[i] = {x[unknown[i]], y[unknown[i]]};
  }

  const EditableSurface& surface_;
  Index center_;
  const base::Host& host_;
  Array<Index> place_;  // in the disk, of each vertex
  Array<Index> loop_;   // half-edges of the outline
};

}  // namespace

Index CornerDisk::nearest(const Eigen::Vector2d& point) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    if ((places[i] - point).squaredNorm() < (places[best] - point).squaredNorm()) best = i;
  return vertices[best];
}

CornerDisk make_disk(const EditableSurface& surface, Index center, int rings, const base::Host& host) {
  CornerDisk disk(host.memory);
  DiskMaker maker(surface, center, host);
  for (; rings > 0; --rings)
    if (maker.build(rings, disk)) return disk;
  throw base::Error("degenerate", "the triangles around vertex " + std::to_string(center) + " are no disk");
}

}  // namespace orbicube::polycube::dissertation

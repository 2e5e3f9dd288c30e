// How much a map is distorted, as a function of the distances between the layers of its polycube (the dissertation's
// section 4.3, with its beta for these distances).
//
// A triangle between two neighboring layers along both axes of its face is stretched with its cell: each term of its
// energy is a constant times powers of the cell's two lengths, so that the triangles of a cell enter by sums made once
// (eq. 4.5 to 4.7). Triangles across layers are few and are evaluated one by one. So a value with its gradient costs
// O(cells + triangles across layers).
#pragma once

#include <limits>

#include "polycube/domain/coordinate_layers.h"

namespace orbicube::polycube {

// Of the energy: a smaller gain is rounding.
inline constexpr double min_energy_gain = 1e-12;

// Each does not change with the size of the polycube, which is measured at the surface's area, and is 1 + area_weight
// for an isometry, more otherwise. `angle` and `area` are those of distortion.h.
enum class DomainMeasure : std::int32_t {
  surface_mean = 0,  // mean over the surface of angle + area_weight * area
  face_mean = 1,     // mean over triangles of the same
  harmonic = 2,      // the dissertation's eq. 4.4 over the area: harmonic energies + area_weight * area stretching
};

class DomainEnergy {
 public:
  // The map and its layers are not kept. Triangles that are degenerate in space do not count, as in distortion.h,
  // but have to keep a positive area on the polycube; those whose area on it is lost in rounding need not.
  DomainEnergy(const SurfaceMap& map, const CoordinateLayers& layers, DomainMeasure measure, double area_weight,
               const base::Host& host);

  std::size_t size() const { return lengths_.size(); }
  std::size_t cells() const { return cells_.size(); }
  std::size_t crossing() const { return crossing_.size(); }
  std::span<const double> lengths() const { return lengths_; }  // of the intervals as they are
  // Of the polycube, with all triangles.
  double area(std::span<const double> lengths) const { return totals(lengths).whole; }

  // The energy for positive lengths of the intervals, and its gradient unless that is empty; infinite, without
  // gradient, where a triangle has no positive area. Keeps intermediate results: not for several threads at once.
  double evaluate(std::span<const double> lengths, std::span<double> gradient) const;

 private:
  // The sums that the energy consists of: area on the polycube, sums of angle, r and 1 / r for the ratio r of areas
  // (each with the triangle's weight), harmonic energy and area stretching; and the area with degenerate triangles.
  struct Totals {
    double whole = 0, area = 0, angle = 0, ratio = 0, inverse = 0, harmonic = 0, stretch = 0;
  };
  struct Corner {
    std::array<std::size_t, 2> interval;  // along the two axes of the face
    std::array<double, 2> fraction;
  };
  struct Crossing {
    std::array<Corner, 3> corner;      // counter-clockwise
    std::array<double, 3> cotangents;  // a quarter of each in space
    double weight, area;               // in space
  };
  // Lengths of a cell: u of interval `first`, v of interval `second`.
  struct Cell {
    void add(const Crossing& triangle);

    std::size_t first, second;
    double angle_first = 0, angle_second = 0;        // of u / v and of v / u
    double ratio = 0, inverse = 0, area = 0;         // of u v, 1 / (u v) and u v
    double whole = 0;                                // of u v
    double harmonic_first = 0, harmonic_second = 0;  // of u^2 and v^2
    double stretch = 0;                              // of (u v)^2
  };
  // A triangle in the plane with what it contributes.
  struct Flat {
    std::array<std::array<double, 2>, 3> at;
    double area, harmonic;
  };

  struct Triangles;

  Triangles find_cells(const SurfaceMap& map, const CoordinateLayers& layers, const base::Host& host);
  void add_triangles(const SurfaceMap& map, const CoordinateLayers& layers, const Triangles& found,
                     const base::Host& host);
  Crossing crossing(const SurfaceMap& map, const CoordinateLayers& layers, Index t, double area, double weight) const;
  Totals totals(std::span<const double> lengths) const;
  double energy(const Totals& t) const;
  // By how much the energy grows with each total.
  Totals slopes(const Totals& t) const;
  void add_gradient(const Totals& slope, std::span<const double> lengths, std::span<double> gradient) const;
  void place(std::span<const double> lengths) const;
  Flat flat(const Crossing& triangle, std::span<const double> lengths) const;

  DomainMeasure measure_;
  double area_weight_;
  double surface_area_ = 0;
  std::array<std::size_t, 4> axis_start_{};  // the first interval of each axis, and the end
  Array<double> lengths_;
  Array<Cell> cells_;
  Array<Crossing> crossing_;
  mutable Array<double> start_;     // of each interval: where it begins along its axis
  mutable Array<double> on_start_;  // gradient for these
};

}  // namespace orbicube::polycube

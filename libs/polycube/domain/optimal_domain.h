// The polycube of the map of minimum distortion among those that differ in the distances between coordinate layers (the
// dissertation's section 4.3): combinatorics, order of layers and total area stay, each vertex moves with the layers
// beside it.
//
// The unknowns are the lengths of the intervals between layers; positions of layers (alpha in eq. 4.9) are sums of
// them, and the area (the last row of eq. 4.9) is met by the scale, on which the energies here do not depend. One row
// keeps the scale. `projected_gradient` minimizes over the lengths within bounds or, by default, over their logarithms:
// each term of the sum of angles and areas at a fixed scale is a positive constant times powers of lengths, a convex
// function of the logarithms.
#pragma once

#include <functional>

#include "polycube/domain/domain_energy.h"
#include "polycube/map/certificate.h"
#include "polycube/surface/distortion.h"

namespace orbicube::polycube {

enum class DomainVariables : std::int32_t {
  logarithms = 0,
  lengths = 1,
};

struct DomainOptions {
  DomainMeasure measure = DomainMeasure::surface_mean;
  double area_weight = 1;  // of areas beside angles, not negative
  DomainVariables variables = DomainVariables::logarithms;
  double gradient_tolerance = 1e-7;  // energies are about 2, and lengths in proportion to their mean
  std::uint64_t max_iterations = 500;
};

struct DomainMinimum {
  explicit DomainMinimum(std::pmr::memory_resource* memory) : lengths(memory), energies(memory) {}

  Array<double> lengths;   // of the intervals, their mean (of logarithms: the mean logarithm) as at the start
  Array<double> energies;  // of the start, and after each iteration; never rises
  std::uint64_t evaluations = 0;
  bool converged = false;  // to the tolerance or as far as rounding allows
};

// No length leaves the range from a thousandth of the start (or of the mean where that is less) to its thousandfold. A
// start at which the energy is not finite is the result. Throws Error "invalid-argument", "cancelled".
DomainMinimum minimise_domain(const DomainEnergy& energy, std::span<const double> start, const DomainOptions& options,
                              const base::Host& host);

// The same for any energy of the lengths, as a sum of several: a value, and the gradient unless that is empty; infinite
// where there is none.
using LengthEnergy = std::function<double(std::span<const double> lengths, std::span<double> gradient)>;
DomainMinimum minimise_domain(const LengthEnergy& energy, std::span<const double> start, const DomainOptions& options,
                              const base::Host& host);

// Layers with these distances times `scale`, about the center that they have. False when rounding joins two.
bool lay_out(const CoordinateLayers& layers, std::span<const double> lengths, double scale,
             std::array<Array<double>, 3>& positions);

struct OptimalDomain {
  explicit OptimalDomain(std::pmr::memory_resource* memory) : energies(memory), certificate(memory) {}

  Array<double> energies;  // of the map given, and after each iteration; never rises. The last is that of the result
  std::uint64_t evaluations = 0;
  bool converged = false;
  std::size_t layers = 0, cells = 0, crossing = 0;  // crossing: triangles across layers
  Certificate certificate;                          // of the result, valid
  Distortion distortion;                            // of the result
};

// Moves map.polycube and nothing else. The map must be certified. The result is certified again, has the area of the
// polycube that was given to rounding, the center of its box, and no more energy; where rounding stands in the way of
// the optimum, what lies between it and the map given, and that map to the bit where nothing better is valid.
// Throws Error "invalid-argument" (options; a map that is not certified), "cancelled".
OptimalDomain optimize_domain(SurfaceMap& map, const DomainOptions& options, const base::Host& host);

}  // namespace orbicube::polycube

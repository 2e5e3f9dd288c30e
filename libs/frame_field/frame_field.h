// Smooth octahedral frame fields on tetrahedral meshes: one frame a tetrahedron, a rotation up to the 24 of the cube,
// with an axis along the normal at the boundary (the dissertation's chapter 6, with today's starts and solvers).
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "frame_field/graph/constraints.h"
#include "frame_field/graph/dual_graph.h"
#include "frame_field/singularities/repair.h"

namespace orbicube::frame_field {

// Where the field comes from before it is smoothed.
enum class Start : std::int32_t {
  automatic = 0,   // several of these, and the best of what they end in, region by region
  identity = 1,    // the axes of space
  propagated = 2,  // the nearest boundary frame
  harmonic = 3,    // degree-4 harmonics that satisfy Laplace's equation, projected
  diffusion = 4,   // harmonic, then diffused and projected with falling times
  given = 5,       // the caller's field
};

// Short English name, e.g. "harmonic". Never null.
const char* start_name(Start start);

enum class Method : std::int32_t {
  smooth = 0,
  dissertation =
      1,  // as printed in chapter 6: identity inside, boundary frames held, matchings frozen (dissertation_method.h)
};

// What is done about edges and vertices that no hexahedral mesh has (repair.h).
enum class Repairs : std::int32_t {
  none = 0,
  places = 1,      // the field is changed where they are
  single_axis = 2  // only fields whose frames turn about one axis along each curve are searched
};

struct Options {
  Start start = Start::automatic;
  Method method = Method::smooth;
  Weighting weighting = Weighting::uniform;
  bool align_boundary = true;
  bool align_stars = false;     // also the frames that meet the boundary in a vertex or an edge alone
  double feature_angle = 0;     // edges of the boundary that turn by more (radians) are followed by an axis; 0: none
  double relative_gain = 1e-6;  // of the last step of smoothing
  std::uint32_t rounds = 2;     // of improvement by Start::automatic
  Repairs repairs = Repairs::none;
};

// What the caller gives besides the mesh; all may be empty.
struct Given {
  std::span<const GivenFrame> frames;      // fixed
  std::span<const GivenAxis> axes;         // one axis of these frames lies along a direction
  std::span<const Quaternion> start = {};  // by tetrahedron, for Start::given
};

struct Outcome {
  explicit Outcome(std::pmr::memory_resource* memory) : field(memory) {}

  Field field;  // by tetrahedron; units
  double energy = 0;
  Start start = Start::identity;  // the one that most of the field comes from
  std::uint32_t solver_iterations = 0;
  std::uint32_t smoothing_steps = 0;
  RepairOutcome repair;  // with repairs
};

// The field of minimum energy that was found. Positions must be finite and tetrahedra positive (mesh/topology/cells.h).
// Throws Error: "empty-mesh" without tetrahedra; "invalid-argument" for what is given or options that are out of range;
// those of TetrahedralConnectivity; "cancelled". O(n), at most 1 KB a tetrahedron.
Outcome compute(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra, const Options& options,
                const Given& given, const base::Host& host);

}  // namespace orbicube::frame_field

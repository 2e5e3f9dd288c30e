// Hexahedral meshes of solids and of closed surfaces: the strategies, the choice among them, and the certified result.
// From here everything else of the library is called.
#pragma once

#include <optional>
#include <span>

#include "hexmesh/captured/feature_figures.h"
#include "hexmesh/regions/conforming_regions.h"
#include "hexmesh/strategies/frame_hexes.h"
#include "hexmesh/strategies/hex_meshing.h"
#include "quaternion/quaternion.h"
#include "volume_map/input/polycube_pieces.h"

namespace orbicube::hexmesh {

// What the hexahedra follow: a polycube of the surface (hex_meshing.h), a grid in space (voxel_hexes.h), a frame field
// (frame_hexes.h); automatic: the one that suits the input, see make_hexahedra().
enum class Method : std::int32_t { automatic = 0, polycube = 1, grid = 2, frames = 3 };

struct Options {
  Method method = Method::automatic;
  Padding padding = Padding::automatic;  // other than automatic: frames are not tried, nor cells of a grid
  std::size_t cells = 10000;             // about
  std::size_t corners = 100;             // maximum number of corners of a polycube; 0: no limit
  std::size_t triangles = 6000;          // larger surfaces are mapped through a coarser one (volume_map/input)
  std::uint64_t seed = 0;
  int rounds = 40;  // of smoothing
  // As in HexOptions.
  double distance = 1;
  std::size_t max_cells = 100'000;
  std::optional<double> feature_angle;  // in degrees; not set: see feature_angle_of()
  // Of a solid, one for each tetrahedron, along its boundary; method automatic or frames. Empty: they are computed.
  std::span<const quaternion::Quaternion> frames = {};
  // Which edges and corners of the surface are measured in the mesh. Where it lacks some, a solid in one piece is
  // filled again, grid-based with the feature graph embedded, by the methods automatic and grid, and the mesh that
  // keeps more of them is the result (feature_choice.h).
  Features features = Features::machined;
  std::span<const mesh::Edge> tagged_edges = {};  // of the input, of vertices of it
  std::span<const Index> tagged_vertices = {};
  // Fills surfaces for frames, which live on tetrahedra. Without it, surfaces have no frames.
  volume_map::FillSurface fill = {};
  // A polycube of the surface; method automatic, which is then that of polycubes, or polycube.
  volume_map::GivenPolycube given = {};
};

// Whether the options name frames as the only strategy.
bool by_frames(const Options& options);
// The angle that is meant. Where none is set: 35 with features, else 40, or 0 along frames only. With the features
// `machined`: that for parts that have features.
double feature_angle_of(const Options& options);

// Whether features were requested, or those of a machined part would be kept.
bool may_have_features(const Options& options);
// Refuses options that are out of range, tags of no vertex of the input, and what does not go together.
void require_valid(const Options& options, std::size_t vertices);

// Of hexahedra along frames.
struct FrameFigures {
  std::size_t inner_irregular_edges = 0;  // with other than four hexahedra
  std::size_t tetrahedra = 0, singular_edges = 0, cut_faces = 0, integers = 0, layer_bounds = 0;
  bool integers_optimal = false;
  std::size_t inverted_at_start = 0, steps = 0;
  std::size_t fields = 0;  // tried, the last being that of the hexahedra; 0: frames were given
  double fill_seconds = 0, field_seconds = 0;
};

struct Hexahedra {
  explicit Hexahedra(std::pmr::memory_resource* memory) : result(memory) {}

  HexResult result;                          // in the coordinates of the input
  Method method = Method::automatic;         // the strategy that made it; grid: where one piece has cells of a grid
  std::size_t polycube_corners = 0;          // of all pieces; 0: there is no polycube
  std::optional<FrameFigures> along_frames;  // where they are
  std::optional<FeatureFigures> features;    // unless they are off
  std::optional<RegionFigures> regions;      // of a solid with regions
  double feature_angle = 0;                  // the one of feature_angle_of()
  double compute_seconds = 0;                // without preparations
};

// Fills a closed surface, or the solid of a mesh of tetrahedra, with hexahedra. Parts of a surface are turned to look
// out of the solid. By the method automatic machined parts (machined_shape.h) go along frames, which know of other than
// right angles and of round edges; others, and where frames are not near or poor, on polycubes, and grid-based where
// these are; along frames again where there is no other way. The better one, if there are two. The result is the same
// for any number of threads. Throws what the strategies do; findings.examined is false while an error is about the
// input.
Hexahedra make_hexahedra(const mesh::Mesh& input, const Options& options, volume_map::InputFindings& findings,
                         const base::Host& host);

}  // namespace orbicube::hexmesh

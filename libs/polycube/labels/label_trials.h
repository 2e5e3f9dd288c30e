// Labelings tried on a surface of few triangles, and those of them that have a map: from coarse to fine with each kind
// of normals, then with boxes for protrusions that the best polycube has no room for.
#pragma once

#include <string>
#include <vector>

#include "polycube/labels/label_construction.h"
#include "polycube/labels/label_cut.h"
#include "polycube/map/distorted_regions.h"
#include "polycube/map/labelled_map.h"
#include "polycube/surface/decimation.h"

namespace orbicube::polycube {

// Normals that labels agree with: as they are, of the surface smoothed, or turned towards the axes where it bends.
enum class LabelNormals { plain, smoothed, turned };

// The surface that labelings are tried on: the input's, or a coarse one made of some of its triangles.
struct SearchSurface {
  SearchSurface(std::span<const Vector3> p, std::span<const Triangle> t, const base::Host& host)
      : decimation(host.memory),
        positions(p.begin(), p.end(), host.memory),
        triangles(t.begin(), t.end(), host.memory),
        source(host.memory) {}

  Decimation decimation;
  Array<Vector3> positions;  // in space
  Array<Triangle> triangles;
  Array<Index> source;  // of each triangle, when it is a coarse one: its number in the input
};

// A labeling with a certified map of the search surface.
struct LabelCandidate {
  double score;  // less is better
  double compactness;
  LabelNormals normals;
  bool drawn;
  Array<AxisLabel> labels;
  SurfaceMap map;
  Certificate certificate;
};

// Reasons why labelings have no map, and how many labelings met each.
class LabelFailures {
 public:
  explicit LabelFailures(const base::Host& host) : host_(host) {}

  // `detail` goes to the log only.
  void add(double compactness, LabelNormals normals, std::size_t corners, const std::string& reason,
           const std::string& detail);
  std::string text() const;

 private:
  struct Failure {
    std::string reason;
    std::size_t fewest, most;  // corners of the polycubes that met it
    std::size_t count;
  };

  const base::Host& host_;
  std::vector<Failure> failures_;
};

class LabelTrials {
 public:
  // Keeps references.
  LabelTrials(const SearchSurface& search, const Frame& frame, const LabelConstructionOptions& options,
              LabelFailures& failures, const base::Host& host);

  // Tries labelings until the map of one is good enough. Returns those that have one, the best first.
  Array<LabelCandidate> run();
  std::size_t tried() const { return tried_; }

 private:
  bool good_enough() const;
  std::span<const Vector3> normals_for(LabelNormals kind);
  bool alike(std::span<const AxisLabel> a, std::span<const AxisLabel> b) const;
  void try_labels(double compactness, LabelNormals normals);
  void pull_out_protrusions();
  void pull_out(const DistortedRegions& regions, Index region, std::size_t candidate, LabelNormals normals);
  void try_map(LabelCosts& costs, Array<AxisLabel> labels, double compactness, LabelNormals normals);
  bool draw(SurfaceMap& map, LabelledMapOutcome& outcome) const;

  const SearchSurface& search_;
  const Frame& frame_;
  const LabelConstructionOptions& options_;
  LabelFailures& failures_;
  const base::Host& host_;
  Surface coarse_;                    // in the frame
  Array<Vector3> smoothed_, turned_;  // its normals, made when they are first requested
  Array<LabelCandidate> candidates_;
  std::size_t tried_ = 0;
  std::size_t changes_left_, steps_left_;
};

}  // namespace orbicube::polycube

// What the verb polycube takes, for one surface and for several.
#pragma once

#include <string>
#include <vector>

#include "polycube/domain/optimal_domain.h"
#include "polycube/map/construction.h"
#include "report/polycube_outputs.h"
#include "session/session.h"
#include "solids/repaired_surface.h"

namespace orbicube::cli {

struct PolycubeOptions {
  std::vector<std::string> inputs;
  std::string input;  // the first
  std::string output;
  std::string surface;
  std::string landmarks;
  std::string from;
  std::string constraints;
  std::string construct = "auto";
  std::size_t corners = 0;
  std::string optimize;
  std::string measure = "surface";
  std::string corner_search = "trust-region";
  double area_weight = 1;
  int rounds =
      -1;  // maximum number of rounds of the method of the dissertation or of the corners; negative: the default
  std::vector<std::string>
      targets;  // files of target positions: of the surface, or of each of several; none for nothing
  double feature_angle = 0;
  bool text = false;
  Mending mending;
  PolycubeOutputs outputs;
};

// The measure of a name of --measure.
polycube::DomainMeasure measure_of(const std::string& name);

// Moves points and curves of a surface to their target positions, and sharp edges to edges of the polycube; figures of
// that go to `figures`. `input` is the file of the surface, `features` that of its features, or empty. Throws Failure.
void align_features(const std::string& input, const std::string& features, double feature_angle,
                    polycube::SurfaceMap& map, polycube::Certificate& certificate, polycube::Distortion& distortion,
                    Json& figures, Session& session);

// One polycube for all inputs. Throws Failure.
void share_one_polycube(const PolycubeOptions& options, Session& session);

}  // namespace orbicube::cli

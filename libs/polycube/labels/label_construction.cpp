#include "polycube/labels/label_construction.h"

#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "polycube/labels/label_trials.h"
#include "polycube/map/whole_surface_map.h"
#include "polycube/surface/alignment.h"
#include "polycube/surface/decimation.h"

namespace orbicube::polycube {
namespace {

class LabelConstruction {
 public:
  LabelConstruction(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                    const LabelConstructionOptions& options, const base::Host& host)
      : positions_(positions),
        triangles_(triangles),
        options_(options),
        host_(host),
        frame_(unit_frame(positions, triangles)),
        fine_(framed(positions, triangles, frame_, host)),
        search_(positions, triangles, host),
        failures_(host) {
    if (triangles.size() > coarse_enough) decimate_search();
    frame_.rotation = best_alignment(fine_, options.seed, host);
    fine_ = framed(positions, triangles, frame_, host);
  }

  Construction run() {
    LabelTrials trials(search_, frame_, options_, failures_, host_);
    Array<LabelCandidate> candidates = trials.run();
    for (LabelCandidate& candidate : candidates) {
      Construction result(host_.memory);
      result.tried = trials.tried();
      result.valid = candidates.size();
      if (finish(candidate, result)) return result;
    }
    throw base::Error("no-valid-result", "none of " + base::counted(trials.tried(), "labeling") +
                                             " has a valid map within the budget. " + failures_.text());
  }

 private:
  void decimate_search() {
    search_.decimation = decimate(fine_, {}, search_triangles, host_);
    search_.source = search_.decimation.left;
    Array<Index> vertices(host_.memory);
    take_left(search_.decimation, positions_, search_.positions, search_.triangles, vertices, host_);
  }

  // Makes the map of the whole surface; returns whether there is one.
  bool finish(LabelCandidate& candidate, Construction& result) {
    std::string reason;
    try {
      reason =
          map_whole_surface({positions_, triangles_, frame_, fine_, search_}, candidate, options_.seed, result, host_);
      if (reason.empty()) return true;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      reason = error.what();
    }
    failures_.add(candidate.compactness, candidate.normals, candidate.certificate.corners, "lost on the whole surface",
                  reason);
    return false;
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  const LabelConstructionOptions& options_;
  const base::Host& host_;
  Frame frame_;
  Surface fine_;
  SearchSurface search_;
  LabelFailures failures_;
};

}  // namespace

Construction construct_by_labels(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                 const LabelConstructionOptions& options, const base::Host& host) {
  return LabelConstruction(positions, triangles, options, host).run();
}

}  // namespace orbicube::polycube

// The spheres of a morph's shapes brought into line, and what is reported of that.
#pragma once

#include <deque>
#include <memory>
#include <string>

#include "correspondence/sphere_alignment.h"
#include "gltf/kept/kept.h"
#include "session/session.h"

namespace orbicube::cli {

struct MorphShape : correspondence::SphereShape {
  using SphereShape::SphereShape;

  std::string path;
  base::Array<mesh::Triangle> given{};       // triangles as in the file
  std::shared_ptr<const gltf::Kept> kept{};  // of the file, where it can be
  Json figures;
};

// Each further sphere is turned to where its positions agree best with those of the first: with `joint`, whichever way
// the shape itself lies; how it is turned for that goes to its figures.
void align_by_correlation(std::deque<MorphShape>& shapes, bool joint, Session& session);

// Notes which shapes do not stand as the first one does, so that they rotate while they become it.
void note_turned(const std::deque<MorphShape>& shapes, Session& session);

// Each further shape is turned so that its landmarks come as near to those of the first as they can, and bent so that
// they meet. Where that would flip triangles that moving vertices a little does not turn back, landmarks go only a
// part of their way, which is noted. Throws Failure.
void align_by_landmarks(std::deque<MorphShape>& shapes, const std::string& path, Session& session);

}  // namespace orbicube::cli

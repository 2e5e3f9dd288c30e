// How the spheres of a morph's shapes are brought into line: turned to where positions agree best, or turned and bent
// until landmarks coincide, and then put onto the common sphere as maps that are one to one there.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <string>

#include "session/session.h"
#include "solids/closed_surface.h"
#include "sphere_map/correspondence/alignment.h"
#include "sphere_map/sampling/locator.h"

namespace orbicube::cli {

struct MorphShape {
  explicit MorphShape(std::pmr::memory_resource* memory) : surface{mesh::Mesh(memory), {}}, directions(memory) {}

  std::string path;
  ClosedSurface surface;
  // The shape's map: on its own sphere at first, once it is brought into line on the common sphere.
  base::Array<mesh::Vector3> directions;
  std::unique_ptr<sphere_map::Locator> locator;
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

// The note on triangles that figures leave out.
#pragma once

#include <string>

#include "base/counted.h"
#include "session/session.h"

namespace orbicube::cli {

inline void note_degenerate(std::size_t triangles, Session& session) {
  if (triangles == 0) return;
  session.note(base::counted(triangles, "triangle is", "triangles are") +
               " degenerate: the height is below 1e-6 of the longest side, or below the rounding of the coordinates; "
               "energies and "
               "distortions leave " +
               (triangles == 1 ? "it" : "them") + " out");
}

}  // namespace orbicube::cli

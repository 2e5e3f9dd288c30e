// The map of a traced surface to its polycube: coarse first, rectangle by rectangle, then vertices are put back one by
// one where they see their whole ring, and every level is smoothed across the cuts between rectangles (as Praun and
// Hoppe 2003 do for the sphere). So no triangle is ever flat or turned, thin protrusions that get little room included,
// which harmonic maps of the whole surface lose in rounding.
#pragma once

#include "polycube/layout/layout.h"
#include "polycube/layout/tracing.h"

namespace orbicube::polycube {

struct LayoutMapOptions {
  int sweeps = 60;  // maximum number over all vertices at the end
};

// `surface` and `drawing` as trace() leaves them. Every triangle of the result is positive, exactly; whether it is a
// polycube map is the certificate's to say (certificate.h). Throws Error "no-valid-result" when a vertex finds no
// place, "cancelled".
SurfaceMap map_layout(const Layout& layout, EditableSurface& surface, Drawing& drawing, const LayoutMapOptions& options,
                      const base::Host& host);

}  // namespace orbicube::polycube

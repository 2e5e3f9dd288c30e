// Where the optimization of a tied map starts.
#pragma once

#include <span>

#include "polycube/labels/arc_signs.h"
#include "polycube/map/tied_map.h"

namespace orbicube::polycube {

// Poisson's equation with gradients that turn each triangle's normal to its label's direction (as Gregson, Sheffer and
// Zhang 2011 do in volumes), the turns within the planes fitted in `rounds` rounds.
void poisson_start(TiedMap& map, int rounds, const base::Host& host);

// How far each arc of the map goes in the direction in which it would be convex: the signs that find_arc_signs wants,
// relative to the square root of the surface's area.
Array<double> target_signs(const TiedMap& map, const ArcNetwork& network, const base::Host& host);

// Patches placed so that every arc runs as its sign says: least squares of the arcs' present lengths, or part of their
// lengths in space where they run the other way, with lower bounds. Returns how many arcs still run the wrong way.
std::size_t place_patches(TiedMap& map, const ArcNetwork& network, const ArcSigns& signs, const base::Host& host);

// With patches where they are: vertices along arcs by arc length, those inside patches by a harmonic map.
void spread_vertices(TiedMap& map, const ArcNetwork& network, const base::Host& host);

}  // namespace orbicube::polycube

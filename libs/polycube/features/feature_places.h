// Places on a polycube as they are seen in the planes of vertices of an unfolded map.
#pragma once

#include "base/heap.h"
#include "mesh/search/nearest.h"
#include "polycube/unfolded/unfolded_map.h"

namespace orbicube::polycube {

class FeaturePlaces {
 public:
  // Of a certified map and what it was unfolded to, with nothing changed since.
  FeaturePlaces(const SurfaceMap& map, const UnfoldedMap& unfolded, const base::Host& host);

  struct InPlane {
    Vector2d place;
    Vector2d along = Vector2d::Zero();  // the direction requested
  };
  // In the plane of the vertex, which is no corner, unfolded along a short way over triangles; with a direction of an
  // axis, 0 to 2, in which the place's face extends, or -1. Throws Error "invalid-argument" for a place that is not on
  // the polycube.
  InPlane find(Index vertex, const Vector3& place, int axis);

 private:
  struct Entry {
    double distance;
    Index face;

    bool operator>(const Entry& other) const { return distance > other.distance; }
  };
  Vector3 centre(Index face) const;
  void reach(Index face, double distance, const PlaneMotion& motion);

  const SurfaceMap& map_;
  const UnfoldedMap& unfolded_;
  const base::Host& host_;
  mesh::SurfaceSearch search_;
  double tolerance_ = 0;
  Array<double> distance_;
  Array<PlaneMotion> motion_;  // from the vertex's plane
  Array<Index> reached_;       // faces to be forgotten
  base::Heap<Entry> heap_;
};

}  // namespace orbicube::polycube

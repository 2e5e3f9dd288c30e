// The queue of vertices of a level: gains are distinguished by powers of two below the level's energy.
#pragma once

#include "base/bucket_queue.h"

namespace orbicube::sphere_map {

using BucketQueue = base::BucketQueue<64>;

}  // namespace orbicube::sphere_map

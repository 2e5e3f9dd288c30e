// The host of most tests: it hears of no progress and does not cancel.
#pragma once

#include "base/host.h"

namespace orbicube::test {

inline const base::Host host;

}  // namespace orbicube::test

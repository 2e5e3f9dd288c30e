// CHOLMOD's factors (Chen, Davis, Hager and Rajamanickam 2008). What links CHOLMOD as it is usually built is bound by
// the GPL, of which some of its modules are.
#pragma once

#include <string>

#include "linear/direct/direct_factor.h"

namespace orbicube::linear {

// For provide_cholmod.
std::unique_ptr<DirectFactor> make_cholmod_factor(DirectMethod method);

// Returns the version of the CHOLMOD that is linked, as "3.0.14".
std::string cholmod_version_text();

}  // namespace orbicube::linear

// Kinds of errors that come from elsewhere, as from callbacks of the C interface.
#pragma once

#include "base/error.h"

namespace orbicube::base {

// The same word in static memory, as an Error needs it; for a word that is not in the table, the first one of the
// status, "internal" where there is none.
const char* known_kind(std::string_view kind, Status status);

}  // namespace orbicube::base

// What helps where an input was refused: what is wrong with it in detail, and which option or verb takes it.
#pragma once

#include <string>

#include "base/host.h"
#include "session/failure.h"

namespace orbicube::cli {

// A sentence to add to the message of the failure, or nothing. The file that it is about is read again, with its
// vertices welded if they were: refusals are rare, and only they pay for that. Throws nothing.
std::string advice(const Failure& failure, const std::string& verb, bool welded, const base::Host& host);

}  // namespace orbicube::cli

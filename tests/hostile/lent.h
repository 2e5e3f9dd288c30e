// What the calls lend to the library: memory that may end, reports that may cancel, and job systems of several manners.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "call.h"

namespace hostile {

// `limited`: the memory is that of our allocator, which has no blocks of more than 256 MB.
void lend(Random& random, bool limited, obc_host& host);

// Memory does not end any more: for what is done after the call.
void allow_allocations();

// Blocks of the host's allocator that are not released yet.
std::size_t blocks_in_use();

// A folder of this process for files, removed with it.
std::string scratch_folder();

}  // namespace hostile

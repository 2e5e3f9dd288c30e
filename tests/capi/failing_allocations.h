// For tests of C functions: makes each allocation fail in turn, or cancels at each progress report in turn, and says
// whether the function kept its promises. Linking failing_allocations.cpp replaces operator new and delete of the test
// program, so that what a library allocates without the host's allocator is counted and fails as well.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "orbicube/base.h"

namespace orbicube::test {

struct Outcome {
  std::size_t runs = 0;  // how often the call ran, the last time undisturbed
  std::string problem;   // empty when every run did as it should
};

// A call that gets a host to hand to the library, releases everything that it made and returns its status. It starts
// from nothing each time it is called; it does not allocate for itself what it keeps.
using Call = std::function<obc_status(const obc_host& host)>;

// Runs `call` with the n-th allocation (operator new or the host's allocator, counted together) failing, for n = 0, 1,
// 2, ... until a run has fewer. Each disturbed run must return OBC_OUT_OF_MEMORY, the last one OBC_OK, and after each
// every block must be released, the host's with the size and alignment it was allocated with. An allocation that cannot
// throw (new (std::nothrow), with which the standard library requires memory that it can do without) may fail
// unnoticed. The host has one thread, so that the order of allocations is always the same. Past the first `each_until`
// allocations only every seventh fails, and of very many one in each 64th of those before: a long call comes to the
// same places again and again, and each run repeats all that went before.
Outcome fail_each_allocation(const Call& call, std::size_t each_until = SIZE_MAX);

// Runs `call` with a progress callback that stops at its n-th call, for n = 0, 1, 2, ... until a run has fewer reports.
// Each stopped run must return OBC_CANCELLED without another report, the last one OBC_OK, and after each every block
// must be released. `max_runs` bounds the work: from there on the step from n to the next doubles.
Outcome cancel_everywhere(const Call& call, std::size_t max_runs = 64);

// How many allocations the program has made so far, to see that something allocates nothing.
std::size_t allocation_count();

}  // namespace orbicube::test

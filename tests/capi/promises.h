// What every C function promises whatever happens on the way, checked by failing_allocations.h.
#pragma once

#include <doctest/doctest.h>

#include "failing_allocations.h"

namespace orbicube::test {

// Each allocation that fails ends the call in out of memory; past the first `each_until` every seventh is tried.
inline void check_failing_allocations(const Call& call, std::size_t each_until = SIZE_MAX) {
  const Outcome outcome = fail_each_allocation(call, each_until);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 10);
}

// Each report of progress may cancel the call.
inline void check_cancelling(const Call& call) {
  const Outcome outcome = cancel_everywhere(call);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 3);
}

// A call of compute(&host, &handle) that destroys what it hands out.
template <class Handle, class Compute>
Call destroying(void (*destroy)(Handle*), const Compute& compute) {
  return [=](const obc_host& host) {
    Handle* made = nullptr;
    const obc_status status = compute(&host, &made);
    destroy(made);
    return status;
  };
}

}  // namespace orbicube::test

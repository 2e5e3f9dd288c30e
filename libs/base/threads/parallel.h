// parallel_for over independent pieces of work, on the host's job system or on threads of our own.
#pragma once

#include <cstddef>
#include <functional>

namespace orbicube::base {

// A host's job system: calls task(i) once for every i in [0, count), on any threads, and returns when all are done.
using Executor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& task)>;

// Calls body(i) for every i in [0, count). Uses `executor` when it is set, else up to `thread_count` threads (0: one a
// core), the caller's among them. The first exception thrown by a body stops the hand-out of further pieces and is
// rethrown once every running piece has ended. Threads live for one call: give it pieces of a tenth of a millisecond
// or more.
void parallel_for(const Executor& executor, unsigned thread_count, std::size_t count,
                  const std::function<void(std::size_t)>& body);

}  // namespace orbicube::base

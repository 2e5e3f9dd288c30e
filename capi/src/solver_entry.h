// What the C functions of every solver have in common: requests, replies, callbacks, saved runs and versions. A handle
// is a struct with the members `adapter` (HostAdapter) and `solver` (the C++ one).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include "base/array.h"
#include "base/version.h"
#include "capi/src/entry.h"

namespace orbicube::capi {

// One member of an options struct from the other, C to C++ or back.
template <class To, class From>
void assign(To& to, const From& from) {
  to = static_cast<To>(from);
}

template <class Handle>
Handle& checked(Handle* solver) {
  require(solver != nullptr, "solver is NULL");
  return *solver;
}

// step(), with `take(solver)` to hand out what is requested.
template <class Handle, class Take>
int32_t step(Handle* handle, const Take& take) {
  if (handle == nullptr) return OBC_INVALID_ARGUMENT;
  int32_t request = 0;
  const obc_status status = guarded(nullptr, [&] { request = static_cast<int32_t>(handle->solver.step()); });
  if (status != OBC_OK) return status;
  take(handle->solver);
  return request;
}

// The reply to a request for value and gradient.
template <class Handle>
obc_status tell_gradient(Handle* handle, double value, const double* gradient, obc_error* error) {
  return guarded(error, [&] {
    auto& solver = checked(handle).solver;
    if (gradient != nullptr) {
      solver.tell(value, {gradient, solver.point().size()});
    } else {
      require(!std::isfinite(value), "gradient is NULL");
      solver.tell_failure();
    }
  });
}

// What callbacks return; the constants of each header have these values.
inline constexpr int32_t answer_continue = 0, answer_stop = 1, answer_failed = 2;

// Runs a solver to its end: evaluate(solver) returns what a callback does, and on answer_continue tell(solver) passes
// on what it found. tell_last(solver) does so before the run is stopped: a value that comes with answer_stop counts.
// multiply(solver) replies to a request for a product of the Hessian.
template <class Solver, class Evaluate, class Tell, class TellLast, class Multiply = std::nullptr_t>
void drive(Solver& solver, const Evaluate& evaluate, const Tell& tell, const TellLast& tell_last,
           const Multiply& multiply = nullptr) {
  using Request = decltype(solver.step());
  for (Request request; (request = solver.step()) != Request::done;) {
    if (request == Request::iteration) continue;
    if constexpr (!std::is_same_v<Multiply, std::nullptr_t>) {
      if (request == Request::need_product) {
        multiply(solver);
        continue;
      }
    }
    const int32_t answer = evaluate(solver);
    if (answer == answer_failed) {
      solver.tell_failure();
    } else if (answer == answer_continue) {
      tell(solver);
    } else {
      tell_last(solver);
      solver.cancel();
    }
  }
}

// The same with f(x, &value, gradient), the gradient in an array of the host's memory.
template <class Solver, class Function, class Multiply = std::nullptr_t>
void drive_gradient(Solver& solver, std::pmr::memory_resource* memory, const Function& f,
                    const Multiply& multiply = nullptr) {
  base::Array<double> gradient(solver.point().size(), 0.0, memory);
  double value;
  drive(
      solver,
      [&](const Solver& asking) {
        value = std::numeric_limits<double>::quiet_NaN();
        return f(asking.point().data(), &value, gradient.data());
      },
      [&](Solver& asking) { asking.tell(value, gradient); },
      [&](Solver& asking) {
        if (!std::isfinite(value)) return;
        std::fill(gradient.begin(), gradient.end(), 0.0);  // the value alone is used, and the gradient may be missing
        asking.tell(value, gradient);
      },
      multiply);
}

inline void throw_if_cancelled(bool cancelled_by_host) {
  if (cancelled_by_host) throw base::Error("cancelled", "stopped by the host");
}

template <class Handle>
std::size_t save_size(const Handle* handle) {
  return handle != nullptr ? handle->solver.save_size() : 0;
}

template <class Handle>
obc_status save(const Handle* handle, void* blob, std::size_t capacity, obc_error* error) {
  return guarded(error, [&] {
    const auto& solver = checked(handle).solver;
    require(blob != nullptr && capacity >= solver.save_size(), "blob is NULL or too small");
    solver.save({static_cast<std::byte*>(blob), solver.save_size()});
  });
}

// `make(bytes)` makes a handle for the run in the blob, by a unique_ptr.
template <class Handle, class Make>
obc_status load(const void* blob, std::size_t size, Handle** out, obc_error* error, const Make& make) {
  return guarded(error, [&] {
    require(out != nullptr && blob != nullptr, "blob or out is NULL");
    *out = nullptr;
    const std::span<const std::byte> bytes(static_cast<const std::byte*>(blob), size);
    std::unique_ptr<Handle> loaded = make(bytes);
    loaded->solver.load(bytes);
    *out = loaded.release();
  });
}

}  // namespace orbicube::capi

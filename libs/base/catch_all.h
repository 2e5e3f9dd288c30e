// The only place of the libraries with `catch (...)`. A thread that ends inside a host's callback (pthread_exit,
// pthread_cancel, a Python daemon thread when the interpreter ends) is unwound by something that looks like an
// exception, but ends the process when it is swallowed: it has to go on through every handler.
#pragma once

#include <exception>  // IWYU pragma: keep: defines __GLIBCXX__

#if defined(__GLIBCXX__)
#include <cxxabi.h>
#endif

namespace orbicube::base {

// Returns body(), or handler() when body throws; in the handler, std::current_exception() and `throw;` mean what was
// thrown. When the thread is being ended, calls on_thread_end() and lets that pass. Never noexcept for this reason, nor
// may a caller be noexcept where a callback of the host is below it.
template <class Body, class Handler, class OnThreadEnd>
auto catch_all(const Body& body, const Handler& handler, [[maybe_unused]] const OnThreadEnd& on_thread_end)
    -> decltype(body()) {
  try {
    return body();
#if defined(__GLIBCXX__)
  } catch (const abi::__forced_unwind&) {
    on_thread_end();
    throw;
#endif
  } catch (...) {
    return handler();
  }
}

template <class Body, class Handler>
auto catch_all(const Body& body, const Handler& handler) -> decltype(body()) {
  return catch_all(body, handler, [] {});
}

}  // namespace orbicube::base

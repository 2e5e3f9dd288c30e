// Thread cancellation (pthread_cancel) of the calling thread. Closing a file or joining a thread is a point where it
// takes effect, and in a destructor that ends the process: it is blocked there, and takes effect at the next report of
// progress.
#pragma once

#if !defined(__EMSCRIPTEN__)
#include <pthread.h>
#endif

namespace orbicube::base {

// Holds cancellation off while it lives.
class CancellationOff {
 public:
#if defined(__EMSCRIPTEN__)
  CancellationOff() {}
  ~CancellationOff() {}
#else
  CancellationOff() {
    pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before_);
  }
  ~CancellationOff() {
    int ignored = 0;
    pthread_setcancelstate(before_, &ignored);
  }
#endif
  CancellationOff(const CancellationOff&) = delete;
  CancellationOff& operator=(const CancellationOff&) = delete;

#if !defined(__EMSCRIPTEN__)
 private:
  int before_ = 0;
#endif
};

// Ends the calling thread here when that was requested.
inline void end_thread_if_cancelled() {
#if !defined(__EMSCRIPTEN__)
  pthread_testcancel();
#endif
}

}  // namespace orbicube::base

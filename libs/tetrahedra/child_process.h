// Work in a child process, whose result comes back as bytes: for code that cannot be stopped, keeps state in globals,
// or crashes. POSIX (fork); glibc, musl from 1.2.2 and the BSDs keep memory allocation usable in the child of a program
// with threads, which is what this relies on.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "base/host.h"

namespace orbicube::tetrahedra {

class ChildProcess {
 public:
  // What the work writes its result to.
  class Output {
   public:
    // Writes all, or ends the child when the parent is gone.
    void write(std::span<const std::byte> bytes) const;
    template <class T>
    void write_values(const T* values, std::size_t count) const {
      write({reinterpret_cast<const std::byte*>(values), count * sizeof(T)});
    }
  };
  // What is done in the child about an exception that leaves the work, before anything is unwound (std::terminate):
  // called where `throw;` throws it again.
  using OnException = void (*)(const Output&);

  // Starts a child that does `work` on a stack of its own and ends. It is quiet (its standard files are /dev/null), has
  // no other file of the parent open, handles no signals, leaves no core file, and, on Linux, ends with its parent.
  // Throws Error "unsupported" when there can be no child, std::bad_alloc.
  ChildProcess(const std::function<void(const Output&)>& work, OnException on_exception);
  // Ends the child if it still runs, and waits for it.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Fills `bytes` with what the child writes next; returns false when it ended before that. Throws Error "cancelled".
  bool read(std::span<std::byte> bytes, const base::Host& host, const char* phase);

  // Waits for the end of a child that has closed its output. The signal that ended it, 0 if none did.
  int wait();

 private:
  pid_t child_ = -1;
  int input_ = -1;
};

}  // namespace orbicube::tetrahedra

// A descriptor of the system that is closed when it is no longer needed.
#pragma once

#include <unistd.h>

#include <utility>

#include "base/threads/cancellation.h"

namespace orbicube::base {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Descriptor() {
    const CancellationOff off;
    if (value_ >= 0) ::close(value_);
  }

  int get() const { return value_; }  // -1: none
  // The caller closes it.
  int release() { return std::exchange(value_, -1); }

 private:
  int value_ = -1;
};

}  // namespace orbicube::base

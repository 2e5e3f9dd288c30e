// The progress bar on a terminal: phase, how far it is, and how long it may still take.
#pragma once

#include <chrono>
#include <string>

#include "base/host.h"

namespace orbicube::cli {

// "1:05 left", "8 s left".
std::string remaining_text(double seconds);

class ProgressBar {
 public:
  // Draws on stderr if `wanted` and it is a terminal, else does nothing.
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const base::Progress& progress);
  // Removes the bar, so that text can follow.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool enabled_;
  bool drawn_ = false;
  const char* phase_ = nullptr;
  Clock::time_point phase_start_{}, last_drawn_{};
};

}  // namespace orbicube::cli

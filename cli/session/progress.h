// The progress bar on a terminal: the completed fraction, the phase, and how long it may still take.
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
  // Shows that all is done, if anything was shown.
  void finish();
  // Removes the bar, so that text can follow.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void draw(double fraction, const std::string& text);

  bool enabled_;
  bool drawn_ = false;   // and not removed
  bool needed_ = false;  // drawn at least once
  Clock::time_point start_, last_drawn_{};
};

}  // namespace orbicube::cli

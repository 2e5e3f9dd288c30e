#include "base/host.h"

#include <limits>

#include "base/error.h"

namespace orbicube::base {

void Host::report(const char* phase, std::uint64_t done, std::uint64_t total) const {
  report(phase, done, total, std::numeric_limits<double>::quiet_NaN());
}

void Host::report(const char* phase, std::uint64_t done, std::uint64_t total, double best) const {
  if (!on_progress) return;
  const auto now = std::chrono::steady_clock::now();
  const bool edge = phase != last_phase_ || (total != 0 && done == total);
  if (!edge && now - last_report_ < std::chrono::milliseconds(20)) return;
  last_phase_ = phase;
  last_report_ = now;
  if (!on_progress(Progress{phase, done, total, best})) {
    throw Error("cancelled", std::string("stopped during ") + phase);
  }
}

void Host::parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) const {
  base::parallel_for(executor, thread_count, count, body);
}

}  // namespace orbicube::base

#include "base/host.h"

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace orbicube::base {

void Host::report(const char* phase, std::uint64_t done, std::uint64_t total) const {
  report(phase, done, total, std::numeric_limits<double>::quiet_NaN());
}

void Host::report(const char* phase, std::uint64_t done, std::uint64_t total, double best) const {
  if (!on_progress) return;
  advance(phase, done, total);
  const auto now = std::chrono::steady_clock::now();
  const bool edge = phase != last_phase_ || (total != 0 && done == total);
  if (!edge && now - last_report_ < std::chrono::milliseconds(20)) return;
  last_phase_ = phase;
  last_report_ = now;
  if (!on_progress(Progress{phase, done, total, best, meter_.at})) {
    throw Error("cancelled", std::string("stopped during ") + phase);
  }
}

void Host::restart() const {
  meter_ = Meter{};
  last_phase_ = nullptr;
}

void Host::advance(const char* phase, std::uint64_t done, std::uint64_t total) const {
  Meter& m = meter_;
  // A phase that starts again is one more; reports without a total, in between others, are of the same one.
  if (phase != m.phase || (total != 0 && done < m.done)) {
    m.phase = phase;
    m.done = m.reports = 0;
    m.phase_at = m.at;
    ++m.phases;
    const unsigned left = m.phases <= m.expected_phases ? m.expected_phases - m.phases + 1 : m.phases + 1;
    m.phase_end = m.at + (m.end - m.at) / left;
  }
  double part = 0;
  constexpr std::uint64_t counted = std::uint64_t{1} << 63U;  // there are totals
  if (total != 0) {
    m.done = done;
    m.reports = counted;
    part = std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
  } else if (m.reports != counted) {
    // Number of reports after which half of the phase is taken for done.
    constexpr double half = 200;
    const auto reports = static_cast<double>(++m.reports);
    part = reports / (reports + half);
  }
  m.at = std::max(m.at, m.phase_at + part * (m.phase_end - m.phase_at));
}

void Host::parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) const {
  base::parallel_for(executor, thread_count, count, body);
}

Stage::Stage(const Host& host, double part, unsigned expected_phases) : host_(host), enclosing_(host.meter_) {
  Host::Meter& m = host.meter_;
  m = Host::Meter{};
  m.at = enclosing_.at;
  m.end = m.at + std::clamp(part, 0.0, 1.0) * (enclosing_.end - m.at);
  m.expected_phases = expected_phases;
  enclosing_.at = m.end;
}

Stage::~Stage() {
  host_.meter_ = enclosing_;
}

}  // namespace orbicube::base

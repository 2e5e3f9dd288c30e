// What the calling program lends to a computation: memory, threads, and a place to report progress to.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <memory_resource>
#include <string>

#include "base/threads/parallel.h"

namespace orbicube::base {

// One report of progress. `best` is the best value of the objective so far, NaN where there is none.
struct Progress {
  const char* phase;  // a string literal
  std::uint64_t done;
  std::uint64_t total;  // 0 where it is not known
  double best;
  double fraction;  // of the whole work that is done, 0 to 1; never less than in an earlier report
};

// Items of well below a microsecond each between two reports: loops over these report every few milliseconds.
inline constexpr std::size_t items_between_reports = 8192;

class Stage;

class Host {
 public:
  // Every member may be left as it is: no progress, the default memory, every core.
  std::function<bool(const Progress&)> on_progress;  // returns false to cancel
  std::function<void(const std::string&)> on_log;    // one line, without a line end
  std::pmr::memory_resource* memory = std::pmr::get_default_resource();
  unsigned thread_count = 0;  // 0: as many as the machine has
  Executor executor;          // replaces our own threads when set

  // Reports to the host how far the work is; throws Error "cancelled" when the host wants it to stop.
  // Cheap (a clock read): call it at least every few milliseconds of work. Reports are passed on at most every 20 ms,
  // but for the first of a phase and the last (done == total). Call from the thread that entered the library only.
  void report(const char* phase, std::uint64_t done, std::uint64_t total, double best) const;
  void report(const char* phase, std::uint64_t done, std::uint64_t total) const;

  // Begins a call of a host that serves several: its first report is passed on, and its fraction starts at 0.
  void restart() const;

  // A line for the log; nothing happens when there is no log.
  void log(const std::string& line) const {
    if (on_log) on_log(line);
  }

  // body(i) for every i in [0, count), in any order and on any thread. What is computed must not depend on the order:
  // results are the same bits for any number of threads. An exception in a body is rethrown here.
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) const;

 private:
  friend class Stage;

  // How much of the whole the current stage covers, and how far it is. The phases of a stage divide what is left of it
  // evenly where their number is known. Else the n-th covers 1 / (n + 1) of what is left, so that any number fits.
  struct Meter {
    double at = 0, end = 1;              // of the whole work
    double phase_at = 0, phase_end = 0;  // what the current phase covers
    unsigned phases = 0, expected_phases = 0;
    std::uint64_t done = 0, reports = 0;  // of the current phase
    const char* phase = nullptr;
  };
  void advance(const char* phase, std::uint64_t done, std::uint64_t total) const;

  mutable Meter meter_;
  mutable const char* last_phase_ = nullptr;
  mutable std::chrono::steady_clock::time_point last_report_{};
};

// A part of the work whose size is known in advance: while it exists, reports are of this part. `part` is the fraction,
// 0 to 1, that it takes of what is left of the enclosing stage (of the whole work where there is none); 0 expected
// phases: not known. Stages nest; at the end of its life a stage is done.
// For the thread that entered the library only, as Host::report().
class Stage {
 public:
  explicit Stage(const Host& host, double part, unsigned expected_phases = 0);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

 private:
  const Host& host_;
  Host::Meter enclosing_;
};

}  // namespace orbicube::base

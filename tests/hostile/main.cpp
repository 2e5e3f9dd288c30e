// Calls every C function of the libraries with hostile arguments, each as often as the others, from a seed.
//
//   hostile-calls [--seed N] [--from CALL] [--runs N] [--seconds S] [--least N] [--slow FACTOR] [--only START] [--list]
//                 [--end-threads] [--exit]
//
// With --end-threads each call is in a thread of its own, which most callbacks end. With --exit the process ends by
// exit() in another thread after S seconds.
//
// Ends with 0 when every function was called `least` times (default 1) and no call failed: no crash, no status that
// there is not, no error without a message, no handle from a call that failed, no block of the host's memory left, no
// call that goes on for long after a report was cancelled. FACTOR stretches the limits of time; START is
// how the names of the functions begin. A call that crashes, or runs for 100 s, is named with its arguments.
#include <pthread.h>
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include "call.h"
#include "lent.h"

using namespace hostile;

namespace {

struct Options {
  std::uint64_t seed = 1, from = 0, runs = UINT64_MAX, least = 1;
  double seconds = 1e9;
  Limits limits;
  std::string only;
  bool list = false, exit = false;
};

struct Tally {
  std::uint64_t calls = 0, succeeded = 0, faults = 0;
  double seconds = 0, longest = 0;
  std::string message;  // of the last error
};

const char* function_at_hand = "none";
const Call* call_at_hand = nullptr;
std::uint64_t number_at_hand = 0;

void tell(int signal) {
  char text[1200];
  const int length = snprintf(text, sizeof text, "signal %d in call %llu: %s (%s)\n", signal,
                              static_cast<unsigned long long>(number_at_hand), function_at_hand,
                              call_at_hand != nullptr ? call_at_hand->outcome.arguments.c_str() : "");
  if (write(STDERR_FILENO, text, static_cast<std::size_t>(length)) < 0) _exit(2);
  ::signal(signal, SIG_DFL);
  raise(signal == SIGPROF ? SIGABRT : signal);
}

Options read_options(int count, char** arguments) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string name = arguments[i];
    options.list |= name == "--list";
    options.exit |= name == "--exit";
    options.limits.ends_threads |= name == "--end-threads";
    if (name == "--list" || name == "--exit" || name == "--end-threads") continue;
    const char* const value = i + 1 < count ? arguments[++i] : "";
    if (name == "--seed") options.seed = std::strtoull(value, nullptr, 10);
    if (name == "--from") options.from = std::strtoull(value, nullptr, 10);
    if (name == "--runs") options.runs = std::strtoull(value, nullptr, 10);
    if (name == "--least") options.least = std::strtoull(value, nullptr, 10);
    if (name == "--seconds") options.seconds = std::strtod(value, nullptr);
    if (name == "--only") options.only = value;
    if (name == "--slow") {
      options.limits.after_cancel *= std::strtod(value, nullptr);
      options.limits.seconds *= std::strtod(value, nullptr);
    }
  }
  return options;
}

void run(const Function& function, std::uint64_t seed, const Limits& limits, Tally& tally) {
  // Only functions that were always quick are called without a host, since nothing can stop them then.
  const bool quick = tally.succeeded >= 5 && tally.longest < 0.02;
  Call call(seed, limits, !function.cancels || quick);
  function_at_hand = function.name;
  call_at_hand = &call;
  const itimerval limit = {{0, 0}, {100, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
  if (limits.ends_threads) {
    const auto body = [&] { function.call(call); };
    pthread_t thread;
    const auto start = [](void* work) -> void* { return (*static_cast<const decltype(body)*>(work))(), nullptr; };
    if (pthread_create(&thread, nullptr, start, const_cast<void*>(static_cast<const void*>(&body))) != 0) std::abort();
    pthread_join(thread, nullptr);
    allow_allocations();
  } else {
    function.call(call);
  }
  call_at_hand = nullptr;
  const Outcome& outcome = call.outcome;
  ++tally.calls;
  tally.succeeded += outcome.succeeded ? 1 : 0;
  tally.seconds += outcome.seconds;
  if (!outcome.message.empty()) tally.message = outcome.message;
  tally.longest = std::max(tally.longest, outcome.seconds);
  if (outcome.fault.empty()) return;
  if (++tally.faults <= 3) {
    std::printf("call %llu, %s: %s (%s); %.2f s, %.2f s after the cancel\n",
                static_cast<unsigned long long>(number_at_hand), function.name,
                (outcome.fault + ": " + outcome.message).c_str(), outcome.arguments.c_str(), outcome.seconds,
                outcome.after_cancel);
    std::fflush(stdout);
  }
}

// Calls all in turn, each round in another order.
void call_all(const std::vector<Function>& chosen, const Options& options, std::vector<Tally>& tallies) {
  Random random(options.seed);
  const auto begun = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(); };
  std::vector<std::size_t> order(chosen.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  for (std::uint64_t n = 0; n < options.runs && !order.empty() && (options.exit || seconds() < options.seconds); ++n) {
    const std::size_t at = n % order.size();
    if (at == 0) {
      for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.below(i)]);
    }
    number_at_hand = n;
    const std::uint64_t seed = random.next();
    if (n < options.from) continue;
    run(chosen[order[at]], seed, options.limits, tallies[order[at]]);
  }
}

// Prints what was found; the exit status.
int report(const std::vector<Function>& chosen, const Options& options, const std::vector<Tally>& tallies,
           double seconds) {
  std::uint64_t calls = 0, faults = 0, seldom = 0, never = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const Tally& tally = tallies[i];
    calls += tally.calls, faults += tally.faults;
    if (tally.calls < options.least) {
      std::printf("%s was called %llu times\n", chosen[i].name, static_cast<unsigned long long>(tally.calls));
      ++seldom;
    }
    if (tally.succeeded == 0) {
      std::printf("%s never succeeded: %s\n", chosen[i].name, tally.message.c_str());
      ++never;
    }
    if (tally.faults > 0)
      std::printf("%s: %llu faults in %llu calls\n", chosen[i].name, static_cast<unsigned long long>(tally.faults),
                  static_cast<unsigned long long>(tally.calls));
    if (options.list)
      std::printf("%-48s %7llu calls %7llu succeeded %8.2f s, longest %.3f s\n", chosen[i].name,
                  static_cast<unsigned long long>(tally.calls), static_cast<unsigned long long>(tally.succeeded),
                  tally.seconds, tally.longest);
  }
  if (blocks_in_use() != 0) std::printf("%zu blocks of the host's memory were not released\n", blocks_in_use());
  std::printf(
      "%llu calls of %zu functions from seed %llu in %.0f s: %llu faults, %llu functions that never succeeded\n",
      static_cast<unsigned long long>(calls), chosen.size(), static_cast<unsigned long long>(options.seed), seconds,
      static_cast<unsigned long long>(faults), static_cast<unsigned long long>(never));
  return faults == 0 && seldom == 0 && blocks_in_use() == 0 && !chosen.empty() ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  const Options options = read_options(count, arguments);
  for (const int signal : {SIGABRT, SIGPROF, SIGSEGV, SIGFPE, SIGBUS, SIGILL})
    ::signal(signal, tell);
  std::vector<Function> chosen;
  for (const Function& function : functions()) {
    if (std::string(function.name).starts_with(options.only)) chosen.push_back(function);
  }
  if (options.exit) {
    // What the calls have is never destroyed, so that only the libraries can be in the way.
    std::thread([&chosen, &options] { call_all(chosen, options, *new std::vector<Tally>(chosen.size())); }).detach();
    std::this_thread::sleep_for(std::chrono::duration<double>(options.seconds));
    std::exit(0);
  }
  const auto begun = std::chrono::steady_clock::now();
  std::vector<Tally> tallies(chosen.size());
  call_all(chosen, options, tallies);
  release_handles();
  return report(chosen, options, tallies,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
}

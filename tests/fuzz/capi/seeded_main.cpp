// Drives a fuzz target without libFuzzer: inputs that follow from a seed, so that every compiler can run it and a crash
// can be repeated.
//
//   fuzz-capi-NAME [--seed N] [--seconds S] [--from INPUT] [--runs N]
//
// Says how many inputs were tried, and which took longest. A crash, or an input that takes more than 100 s of the
// processor's time, says which one it was: --from INPUT --runs 1 repeats it.
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include <sys/time.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::uint64_t seed = 1, current = 0;

std::uint64_t next(std::uint64_t& state) {  // splitmix64
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// Random bytes; in every second input long runs of few values, which lead to plain shapes and to the same choices
// again.
std::vector<std::uint8_t> input(std::uint64_t number) {
  std::uint64_t state = seed * 0x100000001b3ULL + number;
  next(state);
  std::vector<std::uint8_t> bytes(8 + next(state) % (next(state) % 4 == 0 ? 1500 : 200));
  const bool plain = next(state) % 2 == 0;
  std::uint8_t value = 0;
  for (std::uint8_t& byte : bytes) {
    if (!plain || next(state) % 8 == 0) value = static_cast<std::uint8_t>(next(state));
    byte = value;
  }
  return bytes;
}

void tell(int signal) {
  char text[160];
  const int length = std::snprintf(text, sizeof text, "signal %d: --seed %llu --from %llu --runs 1\n", signal,
                                   static_cast<unsigned long long>(seed), static_cast<unsigned long long>(current));
  if (write(STDERR_FILENO, text, static_cast<std::size_t>(length)) < 0) _exit(2);
  std::signal(signal, SIG_DFL);
  std::raise(signal == SIGPROF ? SIGABRT : signal);
}

}  // namespace

int main(int count, char** arguments) {
  std::uint64_t from = 0, runs = UINT64_MAX;
  double seconds = 1e9;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string name = arguments[i];
    if (name == "--seed") seed = std::strtoull(arguments[i + 1], nullptr, 10);
    if (name == "--from") from = std::strtoull(arguments[i + 1], nullptr, 10);
    if (name == "--runs") runs = std::strtoull(arguments[i + 1], nullptr, 10);
    if (name == "--seconds") seconds = std::strtod(arguments[i + 1], nullptr);
  }
  for (const int signal : {SIGABRT, SIGPROF, SIGSEGV, SIGFPE, SIGBUS, SIGILL})
    std::signal(signal, tell);
  const auto start = std::chrono::steady_clock::now();
  std::uint64_t tried = 0, slowest = 0;
  double longest = 0;
  for (; tried < runs; ++tried) {
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > seconds) break;
    current = from + tried;
    const itimerval limit = {{0, 0}, {100, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    const std::vector<std::uint8_t> bytes = input(current);
    const std::clock_t before = std::clock();
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    const double took = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    if (took > longest) {
      longest = took;
      slowest = current;
    }
  }
  std::printf("%llu inputs of seed %llu; the slowest took %.2f s: --from %llu --runs 1\n",
              static_cast<unsigned long long>(tried), static_cast<unsigned long long>(seed), longest,
              static_cast<unsigned long long>(slowest));
  return tried > 0 ? 0 : 1;
}

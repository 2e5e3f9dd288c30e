// What happens in the child stays there.
#include "tetrahedra/child_process.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "base/error.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using test::host;
using tetrahedra::ChildProcess;

namespace {

constexpr const char* phase = "test";

void ignore(const ChildProcess::Output&) {}

template <class T>
bool read(ChildProcess& child, std::span<T> values) {
  return child.read(std::as_writable_bytes(values), host, phase);
}

bool no_child_left() {
  return waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD;
}

}  // namespace

TEST_CASE("What the child writes comes back whole, also when it is more than a pipe holds") {
  std::vector<int> numbers(1 << 20);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::vector<int> answer(numbers.size());
  {
    ChildProcess child([&](const ChildProcess::Output& out) { out.write_values(numbers.data(), numbers.size()); },
                       ignore);
    CHECK(read<int>(child, answer));
    CHECK(answer == numbers);
    std::array<int, 1> more;
    CHECK(!read<int>(child, more));
    CHECK(child.wait() == 0);
  }
  CHECK(no_child_left());
}

TEST_CASE("Exceptions reach the child's own function before anything is unwound") {
  struct Unwound {
    ~Unwound() { raise(SIGKILL); }
  };
  ChildProcess child(
      [](const ChildProcess::Output&) {
        const Unwound guard;
        throw 42;
      },
      [](const ChildProcess::Output& out) {
        try {
          throw;
        } catch (int number) {
          out.write_values(&number, 1);
        }
      });
  std::array<int, 1> number{};
  CHECK(read<int>(child, number));
  CHECK(number[0] == 42);
}

TEST_CASE("A crash of the child is seen as its signal and harms nobody") {
  for (const int signal : {SIGSEGV, SIGABRT, SIGKILL}) {
    ChildProcess child([&](const ChildProcess::Output&) { raise(signal); }, ignore);
    std::array<int, 1> number{};
    CHECK(!read<int>(child, number));
    CHECK(child.wait() == signal);
  }
  CHECK(no_child_left());
}

TEST_CASE("The child has no standard files, none of the parent's others and none of its handlers") {
  const int file = open("/dev/zero", O_RDONLY);
  const int high = fcntl(file, F_DUPFD, 100);
  REQUIRE(high >= 100);
  const auto before = std::signal(SIGUSR1, [](int) {});
  ChildProcess child(
      [&](const ChildProcess::Output& out) {
        std::puts("nobody sees this");
        std::fflush(stdout);
        struct stat standard {
        }, null{};
        stat("/dev/null", &null);
        const std::array<int, 3> found = {fstat(STDOUT_FILENO, &standard) == 0 && standard.st_rdev == null.st_rdev,
                                          fcntl(high, F_GETFD) == -1, std::signal(SIGUSR1, SIG_DFL) == SIG_DFL};
        out.write_values(found.data(), found.size());
      },
      ignore);
  std::array<int, 3> found{};
  CHECK(read<int>(child, found));
  CHECK(found[0] == 1);
  CHECK(found[1] == 1);
  CHECK(found[2] == 1);
  std::signal(SIGUSR1, before);
  close(file);
  close(high);
}

TEST_CASE("A child that never ends is ended when it is left, and when the host cancels") {
  const auto forever = [](const ChildProcess::Output&) {
    while (true)
      pause();
  };
  { const ChildProcess child(forever, ignore); }
  CHECK(no_child_left());
  {
    ChildProcess child(forever, ignore);
    base::Host impatient;
    int reports = 0;
    impatient.on_progress = [&](const base::Progress&) { return ++reports < 5; };
    std::array<int, 1> number{};
    CHECK_THROWS_AS(child.read(std::as_writable_bytes(std::span(number)), impatient, phase), base::Error);
    CHECK(reports == 5);
  }
  CHECK(no_child_left());
}

TEST_CASE("Hosts that let the system reap their children, and handle signals in between, are served as well") {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  {
    ChildProcess child([](const ChildProcess::Output& out) { out.write_values("x", 1); }, ignore);
    std::array<char, 1> text{};
    CHECK(read<char>(child, text));
    CHECK(text[0] == 'x');
    CHECK(child.wait() == 0);
  }
  std::signal(SIGCHLD, before);
}

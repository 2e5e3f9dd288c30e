#include "tetrahedra/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include <cerrno>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "base/error.h"
#include "base/threads/cancellation.h"

namespace orbicube::tetrahedra {
namespace {

constexpr int output_descriptor = 3;  // in the child, beside the three standard ones
constexpr int milliseconds_between_reports = 10;
constexpr std::size_t stack_size = std::size_t{64} << 20;

void close_files_from([[maybe_unused]] int first) {
#ifdef SYS_close_range
  syscall(SYS_close_range, static_cast<unsigned>(first), ~0U, 0U);
#endif
}

// Makes the process one that nobody notices. Only what is safe after a fork.
void withdraw(pid_t parent, int output) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it ended before the line above
#endif
  for (int s = 1; s < NSIG; ++s) {
    struct sigaction standard {};
    standard.sa_handler = SIG_DFL;
    sigaction(s, &standard, nullptr);  // fails for those that cannot be handled and those of the C library
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const struct rlimit no_core {};
  setrlimit(RLIMIT_CORE, &no_core);
  // Out of the way of the standard descriptors, which may be closed in the parent.
  const int high = fcntl(output, F_DUPFD, output_descriptor + 2);
  const int null = open("/dev/null", O_RDWR);
  if (high < 0 || null < 0) _exit(1);
  for (int standard = 0; standard < output_descriptor; ++standard)
    dup2(null, standard);
  dup2(high, output_descriptor);
  close_files_from(output_descriptor + 1);
}

const std::function<void(const ChildProcess::Output&)>* work_of(void* argument) {
  return static_cast<const std::function<void(const ChildProcess::Output&)>*>(argument);
}

// The first function of the thread: above it there is nobody to catch what the work throws, so that std::terminate is
// called before unwinding.
void* run(void* argument) {
  (*work_of(argument))(ChildProcess::Output());
  _exit(0);
}

}  // namespace

void ChildProcess::Output::write(std::span<const std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = ::write(output_descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(1);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

ChildProcess::ChildProcess(const std::function<void(const Output&)>& work, OnException on_exception) {
  const auto refuse = [](const char* what, int reason) {
    if (reason == ENOMEM) throw std::bad_alloc();
    throw base::Error("unsupported",
                      std::string("a child process is needed, but ") + what + ": " + std::strerror(reason));
  };
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) refuse("there is no pipe to it", errno);
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);  // the parent's handlers must not run in the child
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ == 0) {
    withdraw(parent, ends[1]);
    static OnException handler;  // of the child: the handler of std::terminate takes no argument
    handler = on_exception;
    std::set_terminate([] {
      handler(Output());
      _exit(1);
    });
    pthread_attr_t attributes;
    pthread_t thread;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, stack_size);
    if (pthread_create(&thread, &attributes, run, const_cast<void*>(static_cast<const void*>(&work))) == 0)
      pthread_join(thread, nullptr);
    _exit(1);
  }
  const int reason = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  close(ends[1]);
  input_ = ends[0];
  if (child_ > 0) return;
  close(input_);
  refuse("none can be started", reason);
}

ChildProcess::~ChildProcess() {
  const base::CancellationOff off;
  close(input_);
  if (child_ <= 0) return;
  kill(child_, SIGKILL);
  wait();
}

bool ChildProcess::read(std::span<std::byte> bytes, const base::Host& host, const char* phase) {
  while (!bytes.empty()) {
    host.report(phase, 0, 0);
    pollfd ready{input_, POLLIN, 0};
    if (poll(&ready, 1, milliseconds_between_reports) <= 0) continue;
    const ssize_t count = ::read(input_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

int ChildProcess::wait() {
  int status = 0;
  pid_t answer = -1;
  do {
    answer = waitpid(child_, &status, 0);
  } while (answer < 0 && errno == EINTR);
  child_ = -1;
  // Without a status the host waits for its children itself; how this one ended stays unknown.
  return answer > 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace orbicube::tetrahedra

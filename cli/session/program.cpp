#include "session/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

#include "base/error.h"

namespace orbicube::cli {
namespace {

constexpr auto pause_between_reports = std::chrono::milliseconds(20);

pid_t spawned(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  for (int standard = 0; standard < 3; ++standard)
    posix_spawn_file_actions_addopen(&files, standard, "/dev/null", O_RDWR, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  sigset_t handled;  // by the command
  sigemptyset(&handled);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
    sigaddset(&handled, signal);
  posix_spawnattr_setsigdefault(&attributes, &handled);
  pid_t child = -1;
  const int problem = posix_spawn(&child, program.c_str(), &files, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (problem != 0) throw base::Error("io", "cannot start " + program.string() + ": " + std::strerror(problem));
  return child;
}

// Ends a process group unless it has ended by itself.
class Child {
 public:
  explicit Child(pid_t process) : process_(process) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  // The group keeps its number until its first process is waited for.
  ~Child() {
    kill(-process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  std::optional<int> exit_code() const {
    siginfo_t end{};
    if (waitid(P_PID, static_cast<id_t>(process_), &end, WEXITED | WNOHANG | WNOWAIT) != 0 || end.si_pid == 0)
      return std::nullopt;
    return end.si_code == CLD_EXITED ? end.si_status : -1;
  }

 private:
  pid_t process_;
};

}  // namespace

std::optional<std::filesystem::path> find_program(std::initializer_list<const char*> names) {
  const char* folders = std::getenv("PATH");
  for (const char* name : names) {
    std::istringstream list(folders != nullptr ? folders : "");
    for (std::string folder; std::getline(list, folder, ':');) {
      const std::filesystem::path candidate = std::filesystem::path(folder) / name;
      std::error_code problem;
      if (candidate.is_absolute() && std::filesystem::is_regular_file(candidate, problem) &&
          access(candidate.c_str(), X_OK) == 0)
        return candidate;
    }
  }
  return std::nullopt;
}

std::optional<std::filesystem::path> find_browser() {
  return find_program({"chromium", "chromium-browser", "google-chrome"});
}

std::optional<std::filesystem::path> find_opener() {
  return find_program({"xdg-open", "open"});
}

void start_program(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  spawned(program, arguments);
}

int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments, const char* phase,
                const base::Host& host) {
  const Child child(spawned(program, arguments));
  while (true) {
    if (const std::optional<int> code = child.exit_code()) return *code;
    host.report(phase, 0, 0);
    std::this_thread::sleep_for(pause_between_reports);
  }
}

}  // namespace orbicube::cli

#include "report/solver_choice.h"

#include <dlfcn.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "distributed/petsc_engine.h"
#include "session/session.h"

namespace orbicube::cli {
namespace {

// Where building or installing puts modules: beside the command, as the system says where that is, or the folder of the
// build's prefix. Never what the current folder, a variable or the name that the command was called by would lead to:
// what is loaded runs as the user.
std::vector<std::filesystem::path> module_folders() {
  std::vector<std::filesystem::path> folders;
  std::error_code problem;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", problem);
  if (!problem && self.is_absolute()) {
    folders.push_back(self.parent_path() / "distributed");                  // of a build
    folders.push_back(self.parent_path() / ORBICUBE_MODULES_FROM_COMMAND);  // of a prefix that was moved
  }
  folders.emplace_back(ORBICUBE_MODULES);
  return folders;
}

// Whether nobody can have put the file there but the system's owner and the owner of the command.
bool is_as_safe_as_the_command(const std::filesystem::path& path) {
  struct stat command {
  }, module{}, folder{};
  if (::stat("/proc/self/exe", &command) != 0 || ::stat(path.c_str(), &module) != 0 ||
      ::stat(path.parent_path().c_str(), &folder) != 0)
    return false;
  const auto safe = [&](const struct stat& facts) {
    return (facts.st_uid == 0 || facts.st_uid == command.st_uid) && (facts.st_mode & S_IWOTH) == 0;
  };
  return S_ISREG(module.st_mode) && safe(module) && safe(folder);
}

}  // namespace

void add_solver_option(CLI::App& verb, std::string& solver) {
  verb.add_option("--solver", solver,
                  "solver of the linear systems: own, or petsc, on all processes that mpirun starts, in builds with it "
                  "[default: own]")
      ->check(unnamed(CLI::IsMember({"own", "petsc"})))
      ->type_name("NAME");
}

std::optional<std::filesystem::path> petsc_module() {
  for (const std::filesystem::path& folder : module_folders()) {
    const std::filesystem::path path = folder / "orbicube-petsc.so";
    std::error_code problem;
    if (std::filesystem::exists(path, problem)) return path;
  }
  return std::nullopt;
}

std::unique_ptr<untangle::BlockEngine> start_solver(const std::string& solver) {
  if (solver != "petsc") return nullptr;
  const auto path = petsc_module();
  if (!path)
    throw Failure(Exit::wrong_input, "", "unsupported",
                  "the module of PETSc is not installed with the command (build with -Dpetsc=enabled)");
  if (!is_as_safe_as_the_command(*path))
    throw Failure(Exit::wrong_input, path->string(), "unsupported",
                  "the file or its folder belongs to another user, or can be written by all users");
  // Never closed: PETSc and MPI do not stand that.
  void* module = dlopen(path->c_str(), RTLD_NOW | RTLD_GLOBAL);
  void* start = module != nullptr ? dlsym(module, "orbicube_petsc_start") : nullptr;
  if (start == nullptr) {
    const char* reason = dlerror();
    throw Failure(Exit::wrong_input, path->string(), "unsupported", reason != nullptr ? reason : "not a module");
  }
  std::unique_ptr<untangle::BlockEngine> engine(reinterpret_cast<StartPetsc>(start)());
  if (engine == nullptr) std::exit(0);
  return engine;
}

}  // namespace orbicube::cli

#include "solver_choice.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "distributed/petsc_engine.h"
#include "session.h"

namespace orbicube::cli {

void add_solver_option(CLI::App& verb, std::string& solver) {
  verb.add_option("--solver", solver,
                  "of the linear systems: own, or petsc, on all processes that mpirun starts, in builds with it (own)")
      ->check(unnamed(CLI::IsMember({"own", "petsc"})))
      ->type_name("NAME");
}

std::unique_ptr<volume_map::LinearEngine> start_solver(const std::string& solver) {
  if (solver != "petsc") return nullptr;
  std::error_code problem;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", problem);
  std::string reasons;
  for (const std::filesystem::path& folder :
       {self.parent_path() / "distributed", self.parent_path(), std::filesystem::path(ORBICUBE_MODULES)}) {
    const std::filesystem::path path = folder / "orbicube-petsc.so";
    if (!std::filesystem::exists(path, problem)) continue;
    // Never closed: PETSc and MPI do not stand that.
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    void* start = module != nullptr ? dlsym(module, "orbicube_petsc_start") : nullptr;
    if (start == nullptr) {
      const char* reason = dlerror();
      throw Failure(Exit::wrong_input, path.string(), "unsupported", reason != nullptr ? reason : "not a module");
    }
    std::unique_ptr<volume_map::LinearEngine> engine(reinterpret_cast<StartPetsc>(start)());
    if (engine == nullptr) std::exit(0);
    return engine;
  }
  throw Failure(Exit::wrong_input, "", "unsupported", "this build has no PETSc (-Dpetsc=enabled)");
}

}  // namespace orbicube::cli

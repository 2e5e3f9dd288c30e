// The option --solver: what solves the linear systems of maps of solids.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "untangle/tetrahedra/block_assembly.h"

namespace orbicube::cli {

void add_solver_option(CLI::App& verb, std::string& solver);

// Returns the path of the module of PETSc that was built or installed with the command.
std::optional<std::filesystem::path> petsc_module();

// Nothing for "own". For "petsc" the engine of the module that was built or installed with the command, on all
// processes that mpirun started; those but the first work for it, and end here. Throws Failure where there is no such
// module.
std::unique_ptr<untangle::BlockEngine> start_solver(const std::string& solver);

}  // namespace orbicube::cli

// The linear systems of maps of solids by PETSc: conjugate gradients with algebraic multigrid (GAMG), on one process or
// on all that mpirun started. A module of its own, which the command loads when it is requested: nothing else knows of
// PETSc, whose Debian package is linked with libraries under the GPL.
#pragma once

#include "untangle/tetrahedra/block_assembly.h"

namespace orbicube::cli {

// What the module exports under the name orbicube_petsc_start. Starts MPI and PETSc, once in a process. The first
// process gets the engine, which it deletes when it is done; all others work for it until then, and get nothing.
using StartPetsc = untangle::BlockEngine* (*)();

}  // namespace orbicube::cli

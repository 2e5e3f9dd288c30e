// The files of base under the names that readers and writers of meshes use.
#pragma once

#include "base/files/file.h"

namespace orbicube::mesh {

using base::Links;
using base::OutputFile;
using base::read_file;

}  // namespace orbicube::mesh

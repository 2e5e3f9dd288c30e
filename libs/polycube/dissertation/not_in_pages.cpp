// In place of printed_construction.cpp in the module for web pages, which should not be over 3 MB.
#include "base/error.h"
#include "polycube/dissertation/printed_construction.h"

namespace orbicube::polycube::dissertation {

Printed construct_as_printed(std::span<const Vector3>, std::span<const Triangle>, const PrintedOptions&,
                             const base::Host&) {
  throw base::Error("unsupported", "the dissertation's method is not part of the module for web pages");
}

}  // namespace orbicube::polycube::dissertation

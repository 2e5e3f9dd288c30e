#pragma once

namespace orbicube::bench {

// Prints how close runs come to a minimum at the boundary of a hidden domain: f has no value outside of it.
void print_hidden_domain();

}  // namespace orbicube::bench

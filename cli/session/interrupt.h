// Ctrl-C and friends: the first cancels the work, the second ends the program.
#pragma once

namespace orbicube::cli {

// From now on SIGINT, SIGTERM and SIGHUP are remembered, and a closed pipe is an error of writing, not a death.
void watch_for_interrupts();

// Whether one came.
bool interrupted();

}  // namespace orbicube::cli

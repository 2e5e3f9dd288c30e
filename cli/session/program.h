// Other programs of the user's: looked for in PATH and started.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "base/host.h"

namespace orbicube::cli {

// Returns the path of the first of these programs that is in a folder of PATH. Folders that are not absolute are passed
// over: what lies beside the files at hand, which may be anybody's, is not started.
std::optional<std::filesystem::path> find_program(std::initializer_list<const char*> names);

// Return the browser that draws pictures without a screen, and the program that opens a file in the user's browser.
std::optional<std::filesystem::path> find_browser();
std::optional<std::filesystem::path> find_opener();

// Starts a program in a process group of its own, with its standard files at /dev/null, and does not wait for it.
// Throws Error "io".
void start_program(const std::filesystem::path& program, const std::vector<std::string>& arguments);

// Does the same and waits for its end; its exit code, -1 if a signal ended it. `phase` is reported to the host. Throws
// Error "io", "cancelled", and then ends its process group first.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments, const char* phase,
                const base::Host& host);

}  // namespace orbicube::cli

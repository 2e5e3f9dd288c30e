// The table of verbs and options, as `orbicube --describe` prints it: man pages and shell completions are made from it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace orbicube::cli {

// Returns JSON with each verb, its options and what help texts say of them.
std::string description(const CLI::App& app);

}  // namespace orbicube::cli

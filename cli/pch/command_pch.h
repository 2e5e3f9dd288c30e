// Compiled once for all verbs: these two headers take longer to read than most files that include them.
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

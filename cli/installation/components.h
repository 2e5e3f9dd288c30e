// What a build of the command was made with, and the programs that it starts: for `orbicube doctor`.
#pragma once

#include <string>
#include <vector>

namespace orbicube::cli {

struct Component {
  std::string name;
  std::string kind;  // library, module or program
  bool found = false;
  std::string version;     // empty where the library does not say
  std::string place;       // path of a program or a module
  std::string use;         // what it does for the command
  std::string without;     // what a command without it cannot do, or does more slowly
  std::string to_install;  // what to install, and whether to build again
};

// Returns all, present or missing, in the order in which they are shown.
std::vector<Component> components();

// Returns the compiler with its version.
std::string compiler();

}  // namespace orbicube::cli

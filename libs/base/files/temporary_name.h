// Names of files and folders that stand beside an output until it is complete, and what a killed program leaves of
// them.
//
// A name is NAME.orbicube-tmp-RANDOM, NAME being that of the output and RANDOM 128 bits of the system's generator:
// others who may write to the folder cannot lay a link in its way. What has the name is created exclusively, follows no
// link, and stays locked (flock) as long as the program that made it lives; so what has such a name and no lock is left
// over.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace orbicube::base {

// For an output called `name`, which is cut where the system takes no longer names. Throws Error "io" when the system
// has no random numbers.
std::string temporary_name(std::string_view name);

// Whether temporary_name(name) may have given `candidate`.
bool is_temporary_name(std::string_view candidate, std::string_view name);

// Locks what was just created until the descriptor is closed. False where another program, which looks for leftovers,
// was faster: then another name is needed. Systems without locks pass.
bool lock_temporary(int descriptor);

// Removes what killed programs left beside `target`: files, and folders with files, that the same user owns, that are
// no links, have no second name and no lock. Returns their names. At most 100,000 names of the folder are looked at.
// Throws nothing but std::bad_alloc; what cannot be removed stays.
std::vector<std::string> remove_leftovers(const std::filesystem::path& target);

}  // namespace orbicube::base

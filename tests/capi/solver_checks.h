// Checks that the C interfaces of all solvers share.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace orbicube::test {

using Bytes = std::vector<unsigned char>;

// Runs this program again in a new process, only its test case `name`, which gets `blob` by blob_of_first_process() and
// gives a reply by answer_first_process(). Returns that, or nothing when the process failed.
Bytes in_new_process(const std::string& name, const Bytes& blob);

// In the second process. A test case that is for it alone is decorated with doctest::skip(!in_second_process()).
bool in_second_process();
Bytes blob_of_first_process();
void answer_first_process(const void* data, std::size_t size);

// Whether the stops from 0 to `last` have different names, and another number has the name "unknown".
bool names_differ(const char* (*name)(std::int32_t), std::int32_t last);

}  // namespace orbicube::test

// page.html with page.css and the scripts inside, made by embed.py when the command is built.
#pragma once

#include <string>

namespace orbicube::cli {

// The program puts the title at each @TITLE@ and the results, as JSON, at @RESULTS@.
std::string page_template();

}  // namespace orbicube::cli

// Pages with their styles and scripts inside, made by embed.py when the command is built.
#pragma once

#include <string>

namespace orbicube::cli {

// The program (filled_page.h) puts the title at each @TITLE@ and the results, as JSON, at @RESULTS@.
std::string page_template();   // page.html, of maps
std::string study_template();  // study.html, of a study
std::string view_template();   // view_page/view.html, of meshes

}  // namespace orbicube::cli

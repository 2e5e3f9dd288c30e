// A page of template.h with its title and its data.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace orbicube::cli {

// Puts the title, escaped, at each @TITLE@ of the page and the data at @RESULTS@, where nothing in it can end the
// script element. Text that is not UTF-8 is mended.
std::string filled_page(const std::string& empty_page, const std::string& title, const nlohmann::ordered_json& data);

}  // namespace orbicube::cli

#include "report_page/filled_page.h"

#include <string_view>

namespace orbicube::cli {
namespace {

using Json = nlohmann::ordered_json;

// As text of an HTML element.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// JSON that can stand in a script element: nothing in it can end the element. Names that are not UTF-8 are mended.
std::string script_text(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string filled_page(const std::string& empty_page, const std::string& title, const Json& data) {
  const std::string title_text = escaped(title);
  const std::string results_text = script_text(data);

  std::string page;
  page.reserve(results_text.size() + (std::size_t{1} << 16U));
  std::string_view rest = empty_page;
  while (true) {
    const std::size_t mark = rest.find('@');
    page += rest.substr(0, mark);
    if (mark == std::string_view::npos) return page;
    rest.remove_prefix(mark);
    const auto fill = [&](std::string_view name, std::string_view text) {
      if (!rest.starts_with(name)) return false;
      page += text;
      rest.remove_prefix(name.size());
      return true;
    };
    if (!fill("@TITLE@", title_text) && !fill("@RESULTS@", results_text)) fill("@", "@");
  }
}

}  // namespace orbicube::cli

#include "manual/description.h"

#include <sstream>
#include <vector>

#include "base/version.h"
#include "session/session.h"

namespace orbicube::cli {
namespace {

// The words that an option takes, where a check lists them as {a,b}: as description or, in checks that help texts do
// not mention, as name.
std::vector<std::string> choices_of(CLI::Option& option) {
  const auto listed = [](const std::string& text) {
    return text.size() > 2 && text.front() == '{' && text.back() == '}';
  };
  for (int i = 0;; ++i) {
    const CLI::Validator* check = nullptr;
    try {
      check = option.get_validator(i);
    } catch (const CLI::OptionNotFound&) {
      return {};
    }
    std::string text = listed(check->get_name()) ? check->get_name() : check->get_description();
    if (!listed(text)) continue;
    text = text.substr(1, text.size() - 2);
    std::vector<std::string> words;
    std::istringstream list(text);
    for (std::string word; std::getline(list, word, ',');)
      words.push_back(word);
    return words;
  }
}

// "FILE.png" and the like; without the words in braces that CLI11 adds.
std::string name_of_value(const CLI::Option& option) {
  const std::string text = option.get_type_name();
  return text.substr(0, text.find(":{"));
}

Json described(CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames())
    names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    names.push_back("--" + name);
  if (option.get_positional() && names.empty()) names.push_back(option.get_name(true));
  return {{"names", names},
          {"positional", option.get_positional()},
          {"required", option.get_required()},
          {"value", name_of_value(option)},
          {"min_values", option.get_items_expected_min()},
          {"max_values", option.get_items_expected_max()},
          {"choices", choices_of(option)},
          {"group", option.get_group()},
          {"text", option.get_description()}};
}

Json described_options(const CLI::App& app) {
  Json list = Json::array();
  for (const CLI::Option* option : app.get_options())
    list.push_back(described(const_cast<CLI::Option&>(*option)));  // get_validator is not const, and changes nothing
  return list;
}

}  // namespace

std::string description(const CLI::App& app) {
  Json verbs = Json::array();
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    verbs.push_back({{"name", verb->get_name()},
                     {"text", verb->get_description()},
                     {"options", described_options(*verb)},
                     {"notes", verb->get_footer()}});
  const Json all = {{"name", app.get_name()},        {"version", base::version_text},
                    {"text", app.get_description()}, {"options", described_options(app)},
                    {"notes", app.get_footer()},     {"verbs", verbs}};
  return all.dump(1);
}

}  // namespace orbicube::cli

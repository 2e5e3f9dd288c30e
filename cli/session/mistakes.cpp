#include "session/mistakes.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace orbicube::cli {
namespace {

// Damerau and Levenshtein's distance of neighboring letters (optimal string alignment).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j)
    d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string in_small_letters(std::string word) {
  for (char& c : word)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

std::string meant(const std::string& word, const std::vector<std::string>& known) {
  const std::vector<std::string> words = nearest_words(word, known);
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "; did you mean " : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text + (words.empty() ? "" : "?");
}

std::vector<std::string> verbs_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(verb->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  }
  return names;
}

// The first option of the command line that is none of these.
std::string unknown_option(const std::vector<std::string>& known, int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (!word.starts_with("--") || word == "--") continue;
    word = word.substr(0, word.find('='));
    if (std::find(known.begin(), known.end(), word) == known.end()) return word;
  }
  return "";
}

}  // namespace

std::vector<std::string> nearest_words(const std::string& word, const std::vector<std::string>& known) {
  const std::size_t letters = word.size() - std::min(word.find_first_not_of('-'), word.size());
  const std::string given = in_small_letters(word);
  std::vector<std::string> nearest;
  constexpr std::size_t least_beginning = 3, most_beginnings = 3;
  std::ranges::copy_if(known, std::back_inserter(nearest), [&](const std::string& other) {
    return letters >= least_beginning && other.starts_with(given);
  });
  if (!nearest.empty() && nearest.size() <= most_beginnings) return nearest;
  nearest.clear();
  std::size_t least = std::clamp<std::size_t>(letters / 3, 1, 3);
  for (const std::string& other : known) {
    const std::size_t d = distance(given, other);
    if (d < least) nearest.clear();
    if (d <= least) nearest.push_back(other);
    least = std::min(least, d);
  }
  return nearest;
}

std::string mistake(const CLI::ParseError& error, const CLI::App& app, int argc, char** argv) {
  if (const auto verbs = app.get_subcommands(); !verbs.empty()) {
    const std::vector<std::string> known = options_of(*verbs.front());
    const std::string option = unknown_option(known, argc, argv);
    if (option.empty()) return error.what();
    // The name of such an error is that of the verb.
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
      return "there is no option " + option + meant(option, known);
    return error.what() + meant(option, known);
  }
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (!word.starts_with('-')) return "there is no verb '" + word + "'" + meant(word, verbs_of(app));
    if (word.find('=') == std::string::npos) break;  // what follows may be the value of an option
  }
  const std::vector<std::string> known = options_of(app);
  if (const std::string option = unknown_option(known, argc, argv); !option.empty())
    return "there is no option " + option + " before a verb" + meant(option, known);
  return error.get_name() == "RequiredError" ? "a verb is missing" : error.what();
}

}  // namespace orbicube::cli

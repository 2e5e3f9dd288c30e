// What is wrong with a command line, with the verbs and options that were meant most likely.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace orbicube::cli {

// Of `known`, the words that begin with `word`, of at least three letters, if at most three do; else those
// nearest to it, with at most a third of its letters, and at most three, different. Letters that are left out, put in,
// wrong or exchanged count one each; capitals are as small letters.
std::vector<std::string> nearest_words(const std::string& word, const std::vector<std::string>& known);

// The message for the user.
std::string mistake(const CLI::ParseError& error, const CLI::App& app, int argc, char** argv);

}  // namespace orbicube::cli

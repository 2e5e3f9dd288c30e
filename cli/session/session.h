// One run of one verb: the options that all verbs have, what the libraries are lent, and the report.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "base/host.h"
#include "session/failure.h"
#include "session/outputs.h"
#include "session/progress.h"

namespace orbicube::cli {

using Json = nlohmann::ordered_json;

struct CommonOptions {
  bool quiet = false;
  bool verbose = false;
  unsigned threads = 0;
  std::uint64_t seed = 0;
  double time_limit = 0;  // seconds; 0: none
  std::string report;     // path; empty: none
};

class Session {
 public:
  // `input` is what the report calls the input: a path or a shape.
  Session(const CommonOptions& options, std::string verb, std::string input);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const base::Host& host() const { return host_; }
  // Does a part of the verb's work, which takes `part` of what is left of it.
  template <class Work>
  decltype(auto) portion(double part, const Work& work) const {
    const base::Stage stage(host_, part);
    return work();
  }
  bool quiet() const { return options_.quiet; }
  std::uint64_t seed() const { return options_.seed; }

  // The verb's own part of the report, in the order in which it is filled.
  Json& figures() { return figures_; }
  // The arguments of the verb, besides the common options.
  Json& options() { return verb_options_; }
  // Something that was done to the input, for the report and for people.
  // Once, however often it is done.
  void note(const std::string& text) {
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
  }
  const std::vector<std::string>& notes() const { return notes_; }

  double seconds() const;

  // The whole report on stdout in place of what is said, also if quiet.
  void print_report() { report_printed_ = true; }
  // Text for people on stdout, unless quiet, once its outputs are there: at the end of the run, if that is a good
  // one. Ends a line.
  void say(const std::string& line);

  // Where to write an output, which takes its place `target` when the verb ends well, along with all others: the path
  // has the same name and ending. Throws Failure.
  std::filesystem::path stage(const std::filesystem::path& target);
  // Moves the outputs to their targets now, for what is to stay though the run will fail, and says what was to be said.
  void keep();

  // Does the verb's work, then writes the report if one is requested: also of a failure, which is passed on, as a
  // failure by time limit if that is what stopped it.
  template <class Work>
  void run(const Work& work) {
    try {
      work();
      end();
    } catch (const Failure& failure) {
      end_with(failure);
    } catch (const base::Error& error) {
      end_with(failure_of(error, input_, Role::input));
    } catch (const std::bad_alloc&) {
      end_with(out_of_memory(input_));
    } catch (const std::exception& error) {
      end_with(Failure(Exit::no_result, input_, "internal", error.what()));
    }
  }

 private:
  bool goes_on(const base::Progress& progress);
  void tell_at_once(const std::string& line);
  void end();
  [[noreturn]] void end_with(const Failure& failure);
  std::string report(const Json& outcome) const;
  void write_report(const Json& outcome);

  CommonOptions options_;
  std::string verb_;
  std::string input_;
  std::chrono::steady_clock::time_point start_;
  bool out_of_time_ = false;
  bool report_printed_ = false;
  Outputs outputs_;
  std::vector<std::string> lines_;  // to be said
  ProgressBar bar_;
  base::Host host_;
  Json figures_ = Json::object();
  Json verb_options_ = Json::object();
  std::vector<std::string> notes_;
};

// Adds the options that all verbs have.
void add_common_options(CLI::App& app, CommonOptions& options);

// Add an option that means the same in every verb that has it.
void add_text_option(CLI::App& verb, bool& text);
void add_weld_option(CLI::App& verb, bool& weld);

// Checks that help texts do not mention; what they say of themselves becomes their name.
CLI::Validator unnamed(CLI::Validator validator);
// Finite numbers: any; above 0; of at least 0; in a range with its ends. Those of CLI11 let NaN pass.
CLI::Validator finite_number();
CLI::Validator positive_number();
CLI::Validator non_negative_number();
CLI::Validator number_from_to(double low, double high);

// The most memory that the program has used so far, in bytes.
std::uint64_t peak_memory_bytes();

}  // namespace orbicube::cli

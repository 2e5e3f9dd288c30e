// One run of one verb: the options that all verbs have, what the libraries are lent, and the report.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "base/host.h"
#include "failure.h"
#include "progress.h"

namespace orbicube::cli {

using Json = nlohmann::ordered_json;

struct CommonOptions {
  bool quiet = false;
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
  bool quiet() const { return options_.quiet; }
  std::uint64_t seed() const { return options_.seed; }

  // The verb's own part of the report, in the order in which it is filled.
  Json& figures() { return figures_; }
  // What the verb was asked for, besides the common options.
  Json& options() { return verb_options_; }
  // Something that was done to the input, for the report and for people.
  // Once, however often it is done.
  void note(const std::string& text) {
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
  }
  const std::vector<std::string>& notes() const { return notes_; }

  double seconds() const;

  // Text for people on stdout, unless quiet. Ends a line.
  void say(const std::string& line);

  // Does the verb's work, then writes the report if one is wanted: also of a failure, which is passed on, as a failure
  // by time limit if that is what stopped it.
  template <class Work>
  void run(const Work& work) {
    try {
      work();
    } catch (const Failure& failure) {
      end_with(failure);
    } catch (const base::Error& error) {
      end_with(failure_of(error, input_, Role::input));
    } catch (const std::bad_alloc&) {
      end_with(out_of_memory(input_));
    } catch (const std::exception& error) {
      end_with(Failure(Exit::no_result, input_, "internal", error.what()));
    }
    end();
  }

 private:
  bool goes_on(const base::Progress& progress);
  void end();
  [[noreturn]] void end_with(const Failure& failure);
  void write_report(const Json& outcome);

  CommonOptions options_;
  std::string verb_;
  std::string input_;
  std::chrono::steady_clock::time_point start_;
  bool out_of_time_ = false;
  ProgressBar bar_;
  base::Host host_;
  Json figures_ = Json::object();
  Json verb_options_ = Json::object();
  std::vector<std::string> notes_;
};

// Adds the options that all verbs have.
void add_common_options(CLI::App& app, CommonOptions& options);

// A check that help texts do not mention.
CLI::Validator unnamed(CLI::Validator validator);

// The most memory that the program has used so far, in bytes.
std::uint64_t peak_memory_bytes();

}  // namespace orbicube::cli

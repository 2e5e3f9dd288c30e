#include "session/session.h"

#include <sys/resource.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>

#include "base/version.h"
#include "mesh/files/file.h"
#include "report/advice.h"
#include "report/text.h"
#include "session/interrupt.h"

namespace orbicube::cli {
namespace {

CLI::Validator seed_check() {
  return {[](const std::string& text) {
            const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
            std::uint64_t value = 0;
            const bool fits = std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
            return digits && fits ? std::string() : "'" + text + "' is no whole number from 0 to 2^64 - 1";
          },
          ""};
}

// Numbers that hold, as "a number above 0".
template <class Holds>
CLI::Validator number_check(const std::string& what, const Holds& holds) {
  return {[=](const std::string& text) {
            double value = 0;
            const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && holds(value);
            return good ? std::string() : "'" + text + "' is not " + what;
          },
          ""};
}

}  // namespace

Session::Session(const CommonOptions& options, std::string verb, std::string input)
    : options_(options),
      verb_(std::move(verb)),
      input_(std::move(input)),
      start_(std::chrono::steady_clock::now()),
      bar_(!options.quiet) {
  host_.thread_count = options.threads;
  host_.on_progress = [this](const base::Progress& progress) { return goes_on(progress); };
  if (options.verbose) host_.on_log = [this](const std::string& line) { tell_at_once(line); };
}

double Session::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool Session::goes_on(const base::Progress& progress) {
  bar_.show(progress);
  if (options_.time_limit > 0 && seconds() > options_.time_limit) out_of_time_ = true;
  return !out_of_time_ && !interrupted();
}

void Session::tell_at_once(const std::string& line) {
  bar_.clear();
  std::fprintf(stderr, "%8.1f s  %s\n", seconds(), printable(line).c_str());
}

void Session::say(const std::string& line) {
  if (options_.quiet) return;
  lines_.push_back(line);
}

std::filesystem::path Session::stage(const std::filesystem::path& target) {
  std::filesystem::path path = outputs_.stage(target);
  for (const std::string& name : outputs_.leftovers())
    note("what a killed run had left was removed: " + name);
  return path;
}

void Session::keep() {
  outputs_.commit();
  bar_.clear();
  for (const std::string& line : lines_)
    std::cout << printable(line) << '\n';
  lines_.clear();
}

void Session::end() {
  bar_.finish();
  const Json outcome = {{"exit_code", static_cast<int>(Exit::done)}};
  write_report(outcome);
  if (report_printed_) lines_ = {report(outcome)};
  keep();
}

void Session::end_with(const Failure& failure) {
  bar_.clear();
  Failure told = failure;
  if (failure.kind() == "cancelled") {
    // What is stopped is the work on the input, whichever file it was at.
    const std::string limit = "the limit of " + Json(options_.time_limit).dump() + " s is over; ";
    told = Failure(failure.exit_code(), input_, out_of_time_ ? "time-limit" : "cancelled",
                   (out_of_time_ ? limit : "") + failure.what());
  }
  const bool welded = verb_options_.is_object() && verb_options_.value("weld", false);
  if (const std::string more = advice(told, verb_, welded, host_); !more.empty())
    told = Failure(told.exit_code(), told.file(), told.kind(), told.what() + ("; " + more));
  try {
    outputs_.discard();
    write_report({{"exit_code", static_cast<int>(told.exit_code())},
                  {"error", {{"file", told.file()}, {"kind", told.kind()}, {"message", told.what()}}}});
    outputs_.commit();
  } catch (const Failure&) {
    // The first failure is the one to tell.
  }
  throw told;
}

std::string Session::report(const Json& outcome) const {
  Json report = {{"command", verb_}, {"input", input_}, {"version", base::version_text}};
  report["options"] = verb_options_;
  report["options"].update(
      {{"threads", options_.threads}, {"seed", options_.seed}, {"time_limit", options_.time_limit}});
  report.update(outcome);
  report.update(figures_);
  report["notes"] = notes_;
  report["seconds"] = seconds();
  report["peak_memory_bytes"] = peak_memory_bytes();
  // Names that are not UTF-8 must not keep the figures from being written.
  return report.dump(2, ' ', false, Json::error_handler_t::replace);
}

void Session::write_report(const Json& outcome) {
  if (options_.report.empty()) return;
  about(options_.report, Role::output, [&] {
    mesh::OutputFile file(stage(options_.report));
    file.write(report(outcome) + "\n");
    file.commit();
  });
}

CLI::Validator unnamed(CLI::Validator validator) {
  validator.name(validator.get_description());
  return validator.description("");
}

CLI::Validator finite_number() {
  return number_check("a finite number", [](double) { return true; });
}

CLI::Validator positive_number() {
  return number_check("a number above 0", [](double value) { return value > 0; });
}

CLI::Validator non_negative_number() {
  return number_check("a number of at least 0", [](double value) { return value >= 0; });
}

CLI::Validator number_from_to(double low, double high) {
  return number_check("a number from " + number(low) + " to " + number(high),
                      [=](double value) { return value >= low && value <= high; });
}

void add_text_option(CLI::App& verb, bool& text) {
  verb.add_flag("--text", text, "write text in place of binary, in formats with both");
}

void add_weld_option(CLI::App& verb, bool& weld) {
  verb.add_flag("--weld", weld, "weld vertices at identical positions if the surface is not closed");
}

void add_common_options(CLI::App& app, CommonOptions& options) {
  const char* group = "Options of every verb";
  app.add_flag("--quiet", options.quiet, "print errors only, no text and no progress bar")->group(group);
  app.add_flag("--verbose", options.verbose, "print to stderr what is tried, as it happens, with the seconds so far")
      ->group(group);
  app.add_option("--threads", options.threads,
                 "number of threads, 0: one a core; results are the same for any number [default: 0]")
      ->check(unnamed(CLI::Range(0, 4096)))
      ->type_name("N")
      ->group(group);
  app.add_option("--seed", options.seed, "seed of random choices [default: 0]")
      ->check(seed_check())
      ->type_name("N")
      ->group(group);
  app.add_option("--time-limit", options.time_limit, "stop after S seconds, with exit code 1")
      ->check(positive_number())
      ->type_name("S")
      ->group(group);
  app.add_option("--report", options.report, "write the figures to this file, as JSON")
      ->type_name("FILE.json")
      ->group(group);
}

std::uint64_t peak_memory_bytes() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

}  // namespace orbicube::cli

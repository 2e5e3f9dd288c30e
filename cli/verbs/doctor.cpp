// orbicube doctor: what this build of the command can do, what is missing, and what that costs.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "base/counted.h"
#include "base/version.h"
#include "files/surface_file.h"
#include "installation/components.h"
#include "installation/machine.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct DoctorOptions {
  bool json = false;
};

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json figures_of(const Component& component) {
  return {{"name", component.name},
          {"kind", component.kind},
          {"found", component.found},
          {"version", text_or_null(component.version)},
          {"path", text_or_null(component.place)},
          {"use", component.use},
          {"without", text_or_null(component.without)},
          {"install", text_or_null(component.to_install)}};
}

std::string row(const std::string& name, const std::string& value) {
  constexpr std::size_t width = 16;
  return "  " + name + std::string(name.size() < width ? width - name.size() : 1, ' ') + value;
}

std::string gibibytes(std::uint64_t bytes) {
  const std::uint64_t tenths = bytes / ((std::uint64_t{1} << 30) / 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GiB";
}

std::string memory_text(const Machine& machine) {
  return machine.memory_bytes == 0
             ? std::string("unknown")
             : gibibytes(machine.memory_bytes) + ", " + gibibytes(machine.free_memory_bytes) + " free";
}

void say_component(const Component& component, Session& session) {
  if (component.found) {
    std::string text = component.version;
    if (!component.place.empty()) text = component.place;
    session.say(row(component.name, (text.empty() ? "" : text + ": ") + component.use));
    return;
  }
  session.say(row(component.name, "MISSING: " + component.without));
  session.say(row("", "to install: " + component.to_install));
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : " ") + word;
  return text;
}

void doctor(const DoctorOptions& options, const std::vector<std::string>& verbs, Session& session) {
  session.options() = {{"json", options.json}};
  const std::vector<Component> all = components();
  const Machine own = machine();
  std::vector<std::string> missing;
  Json list = Json::array();
  for (const Component& component : all) {
    list.push_back(figures_of(component));
    if (!component.found) missing.push_back(component.name);
  }
  session.figures() = {
      {"compiler", compiler()},
      {"verbs", verbs},
      {"formats", {{"surfaces", surface_endings}, {"cells", cell_endings}}},
      {"components", list},
      {"missing", missing},
      {"machine",
       {{"cores", own.cores}, {"memory_bytes", own.memory_bytes}, {"free_memory_bytes", own.free_memory_bytes}}}};
  session.say(std::string("orbicube ") + base::version_text + ", compiled by " + compiler());
  session.say(row("verbs", joined(verbs)));
  session.say(row("surfaces", surface_endings));
  session.say(row("cells", cell_endings));
  for (const Component& component : all)
    say_component(component, session);
  session.say(row("cores", std::to_string(own.cores)));
  session.say(row("memory", memory_text(own)));
  session.say(missing.empty() ? "nothing is missing"
                              : base::counted(missing.size(), "component") + " missing: " + joined(missing));
  if (options.json) session.print_report();
}

}  // namespace

void add_doctor(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("doctor", "report what this build can do and what is missing");
  const auto options = std::make_shared<DoctorOptions>();
  verb->add_flag("--json", options->json, "print the report, as JSON, in place of the text");
  add_common_options(*verb, common);
  verb->footer("Missing components are reported, and are no error: the exit code is 0.");
  verb->callback([options, &app, &common] {
    std::vector<std::string> verbs;
    for (const CLI::App* other : app.get_subcommands([](const CLI::App*) { return true; }))
      verbs.push_back(other->get_name());
    Session session(common, "doctor", "");
    session.run([&] { doctor(*options, verbs, session); });
  });
}

}  // namespace orbicube::cli

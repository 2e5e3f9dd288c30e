#include "report/repair_outlook.h"

#include <algorithm>
#include <cstdio>

#include "base/counted.h"
#include "repair/repair.h"
#include "report/text.h"
#include "solids/repaired_surface.h"

namespace orbicube::cli {
namespace {

// Lines of one kind of defect. Larger: more places on the screen; the report has them all.
constexpr std::size_t max_lines = 5;
// Where the search for the loops of all handles takes less than a second or so.
constexpr std::int64_t max_genus = 8;
constexpr std::size_t max_triangles = 30'000;

std::string place(const mesh::Vector3& p) {
  return "(" + number(p[0]) + ", " + number(p[1]) + ", " + number(p[2]) + ")";
}

// One line for each place of an action, as "hole of 12 edges, length 0.53, at (0, 1, 2)".
template <class Text>
void add_places(const repair::Repaired& repaired, repair::Action action, const char* many, const Text& text,
                std::vector<std::string>& lines) {
  std::vector<const repair::Event*> events;
  for (const repair::Event& e : repaired.events) {
    if (e.action == action) events.push_back(&e);
  }
  std::stable_sort(events.begin(), events.end(), [](const auto* a, const auto* b) { return a->size > b->size; });
  for (std::size_t i = 0; i < std::min(events.size(), max_lines); ++i)
    lines.push_back(text(*events[i]) + " at " + place(events[i]->place));
  if (events.size() > max_lines)
    lines.push_back("and " + std::to_string(events.size() - max_lines) + " smaller " + many);
}

// The handles of what a repair would leave.
void add_handles(const repair::Repaired& repaired, Session& session, RepairOutlook& outlook) {
  const repair::Certificate& c = repaired.report.certificate;
  if (!c.is_solid() || c.genus < 1 || c.genus > max_genus || repaired.surface.triangles.size() > max_triangles) return;
  repair::Options options;
  options.find_intersections = false;
  options.parts.keep = 0;
  options.handles.max_genus = 0;
  const repair::Repaired cut =
      repair::repair(repaired.surface.positions, repaired.surface.triangles, options, session.host());
  Json handles = Json::array();
  for (const repair::Event& e : cut.events) {
    if (e.action != repair::Action::cut_handle) continue;
    handles.push_back({{"place", {e.place[0], e.place[1], e.place[2]}}, {"edges", e.count}, {"length", e.size}});
    outlook.lines.push_back("handle or tunnel with a loop of " + base::counted(e.count, "edge") + ", length " +
                            number(e.size) + ", around " + place(e.place));
  }
  outlook.figures["handles"] = handles;
}

}  // namespace

RepairOutlook repair_outlook(const mesh::Mesh& surface, Session& session) {
  RepairOutlook outlook;
  try {
    repair::Options options;
    options.find_intersections = false;
    const repair::Repaired repaired = repair::repair(surface.positions, surface.triangles, options, session.host());
    outlook.figures = figures_of_repair(repaired);
    // Not searched for here; the rows of the surface say whether it meets itself.
    outlook.figures["certificate"].erase("self_intersections");
    outlook.lines = lines_of(repaired.report);
    add_places(
        repaired, repair::Action::dropped_part, "parts",
        [](const repair::Event& e) {
          return "part of " + base::counted(e.count, "triangle") + ", area " + number(e.size);
        },
        outlook.lines);
    add_places(
        repaired, repair::Action::filled_hole, "holes",
        [](const repair::Event& e) {
          return "hole of " + base::counted(e.count, "edge") + ", length " + number(e.size);
        },
        outlook.lines);
    add_places(
        repaired, repair::Action::split_contact_edge, "contacts",
        [](const repair::Event& e) { return "contact of " + std::to_string(e.count) + " faces at one edge"; },
        outlook.lines);
    add_handles(repaired, session, outlook);
  } catch (const base::Error& refusal) {
    if (refusal.status() == base::Status::cancelled) throw;
    outlook.lines = {std::string("no, ") + refusal.kind() + ": " + refusal.what()};
    outlook.figures = {{"kind", refusal.kind()}, {"reason", refusal.what()}};
  }
  return outlook;
}

}  // namespace orbicube::cli

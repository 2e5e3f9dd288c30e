// A run as bytes.
#include "base/files/saved_run.h"
#include "trust_region/solver.h"

namespace orbicube::trust_region {
namespace {

struct Description {
  std::uint64_t fingerprint;  // of the problem
  std::uint64_t whole;        // what room the solver had
  Options options;
};
constexpr base::SavedRun<Description> saved_run("OBCTRGN5", "trust_region");

}  // namespace

template <class Self, class Visit>
void Solver::visit_state(Self& self, const Visit& visit) {
  visit(std::span(&self.state_, 1));
  for (auto* array : {&self.best_, &self.best_outputs_, &self.values_, &self.start_, &self.design_, &self.requests_,
                      &self.told_, &self.step_})
    visit(std::span(*array));
  visit(std::span(self.axes_));
  Variables::visit_state(self.variables_, visit);
  Interpolation::visit_state(self.interpolation_, visit);
  Models::visit_state(self.models_, visit);
  Edges::visit_state(self.edges_, visit);
}

std::size_t Solver::save_size() const {
  return saved_run.size([this](const auto& visit) { visit_state(*this, visit); });
}

void Solver::save(std::span<std::byte> blob) const {
  saved_run.write(blob, {variables_.fingerprint(), whole_, options_},
                  [this](const auto& visit) { visit_state(*this, visit); });
}

Options Solver::options_of(std::span<const std::byte> blob) {
  return saved_run.description(blob).options;
}

void Solver::load(std::span<const std::byte> blob) {
  const Description saved = saved_run.description(blob);
  const bool same = saved.fingerprint == variables_.fingerprint();
  if (same && saved.whole != 0) allocate(true);
  saved_run.read(blob, same, [this](const auto& visit) { visit_state(*this, visit); });
  options_ = saved.options;
}

}  // namespace orbicube::trust_region

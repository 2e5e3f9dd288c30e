// A run as bytes.
#include "base/files/saved_run.h"
#include "projected_gradient/solver.h"

namespace orbicube::projected_gradient {
namespace {

struct Description {
  std::uint64_t fingerprint;  // of the problem
  Options options;
};
constexpr base::SavedRun<Description> saved_run("OBCPGRD6", "projected_gradient");

}  // namespace

template <class Self, class Visit>
void Solver::visit_state(Self& self, const Visit& visit) {
  visit(std::span(&self.state_, 1));
  for (auto* array : {&self.x_, &self.gradient_, &self.trial_, &self.trial_gradient_, &self.direction_, &self.best_,
                      &self.multipliers_, &self.last_values_}) {
    visit(std::span(*array));
  }
  LimitedMemory::visit_state(self.limited_, visit);
  DenseModel::visit_state(self.dense_, visit);
  FeasibleSet::visit_state(self.set_, visit);
}

std::size_t Solver::save_size() const {
  return saved_run.size([this](const auto& visit) { visit_state(*this, visit); });
}

void Solver::save(std::span<std::byte> blob) const {
  saved_run.write(blob, {set_.fingerprint(), options_}, [this](const auto& visit) { visit_state(*this, visit); });
}

Options Solver::options_of(std::span<const std::byte> blob) {
  return saved_run.description(blob).options;
}

void Solver::load(std::span<const std::byte> blob) {
  const Description saved = saved_run.description(blob);
  const bool same = saved.fingerprint == set_.fingerprint() && saved.options.method == options_.method;
  saved_run.read(blob, same, [this](const auto& visit) { visit_state(*this, visit); });
  options_ = saved.options;
}

}  // namespace orbicube::projected_gradient

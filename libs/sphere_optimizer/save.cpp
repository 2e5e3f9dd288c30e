// A run as bytes.
#include "base/files/saved_run.h"
#include "sphere_optimizer/solver.h"

namespace orbicube::sphere_optimizer {
namespace {

struct Description {
  std::uint64_t count, dimension;
  Options options;
};
constexpr base::SavedRun<Description> saved_run("OBCSPHR6", "sphere_optimizer");

}  // namespace

template <class Self, class Visit>
void Solver::visit_state(Self& self, const Visit& visit) {
  visit(std::span(&self.state_, 1));
  for (auto* array : {&self.x_, &self.gradient_, &self.trial_, &self.trial_gradient_, &self.direction_, &self.velocity_,
                      &self.best_, &self.radial_, &self.trial_radial_, &self.curvature_, &self.ambient_,
                      &self.trial_ambient_, &self.last_values_, &self.lowest_point_}) {
    visit(std::span(*array));
  }
  LimitedMemory::visit_state(self.memory_, visit);
  NewtonStep::visit_state(self.newton_step_, visit);
}

std::size_t Solver::save_size() const {
  return saved_run.size([this](const auto& visit) { visit_state(*this, visit); });
}

void Solver::save(std::span<std::byte> blob) const {
  saved_run.write(blob, {shape_.count, shape_.dimension, options_},
                  [this](const auto& visit) { visit_state(*this, visit); });
}

Options Solver::options_of(std::span<const std::byte> blob) {
  return saved_run.description(blob).options;
}

Shape Solver::shape_of(std::span<const std::byte> blob) {
  const Description saved = saved_run.description(blob);
  return {static_cast<std::size_t>(saved.count), static_cast<std::size_t>(saved.dimension)};
}

void Solver::load(std::span<const std::byte> blob) {
  const Description saved = saved_run.description(blob);
  const bool same =
      saved.count == shape_.count && saved.dimension == shape_.dimension && saved.options.method == options_.method;
  saved_run.read(blob, same, [this](const auto& visit) { visit_state(*this, visit); });
  options_ = saved.options;
}

}  // namespace orbicube::sphere_optimizer

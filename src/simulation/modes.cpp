#include "coilwright/simulation/modes.hpp"

#include <algorithm>
#include <complex>
#include <numbers>
#include <numeric>

#include "linear_system.hpp"

namespace coilwright::simulation {
namespace {

void add_mode(std::complex<double> value, std::vector<Mode>& out) {
  if (value.imag() < 0.0) return;  // its conjugate stands for both
  const double size = std::abs(value);
  out.push_back(
      {.natural_frequency = size / (2.0 * std::numbers::pi), .damping_ratio = size > 0.0 ? -value.real() / size : 0.0});
}

// As many real eigenvalues as there are states of effects in the system are those states' own: the ones in which they
// take the greatest part (participation factors: right times left eigenvector, entry by entry).
std::vector<Mode> modes_beside_effects(const LinearSystem& system) {
  const LinearSystem::Decomposition eigen = system.decomposition();
  const Eigen::Index size = system.matrix.rows();
  const auto part = [&](Eigen::Index mode) {
    double sum = 0.0;
    for (Eigen::Index i = size - system.relaxing; i < size; ++i)
      sum += std::abs(eigen.right(i, mode) * eigen.left(mode, i));
    return sum;
  };
  std::vector<Eigen::Index> real;
  std::vector<Mode> out;
  for (Eigen::Index i = 0; i < size; ++i) {
    if (eigen.values[i].imag() == 0.0)
      real.push_back(i);
    else
      add_mode(eigen.values[i], out);
  }
  std::ranges::stable_sort(real, std::greater<>(), part);
  for (std::size_t i = std::min(real.size(), static_cast<std::size_t>(system.relaxing)); i < real.size(); ++i)
    add_mode(eigen.values[real[i]], out);
  return out;
}

std::vector<Mode> modes_of_chain(const LinearSystem& system) {
  std::vector<Mode> out;
  for (const std::complex<double> value : system.eigenvalues()) add_mode(value, out);
  return out;
}

}  // namespace

std::vector<Mode> modes(const actuator::Model& model, const mechanics::JointVector& angles,
                        const actuator::CoilCurrents& currents) {
  const LinearSystem system = linear_system(model, angles, currents);
  std::vector<Mode> out = system.relaxing == 0 ? modes_of_chain(system) : modes_beside_effects(system);
  std::ranges::sort(out, {}, &Mode::natural_frequency);
  return out;
}

}  // namespace coilwright::simulation

#include "coilwright/actuator/design/current_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace coilwright::actuator {

std::vector<double> current_shares(const Design& design) {
  std::vector<double> out(static_cast<std::size_t>(coil_count(design.layout)), 1.0);
  const std::size_t stated = std::min(out.size(), design.coil.current_shares.size());
  std::copy_n(design.coil.current_shares.begin(), stated, out.begin());
  return out;
}

bool has_one_current(const Design& design) {
  return std::ranges::all_of(current_shares(design), [](double share) { return share == 1.0; });
}

double largest_current_share(const Design& design) {
  double out = 0.0;
  for (const double share : current_shares(design)) out = std::max(out, std::abs(share));
  return out;
}

int share_without_coil(const Design& design) {
  for (int i = coil_count(design.layout); i < most_current_shares; ++i)
    if (design.coil.current_shares[static_cast<std::size_t>(i)] != 1.0) return i + 1;
  return 0;
}

void require_one_current(const Design& design, const std::string& what) {
  const std::vector<double> shares = current_shares(design);
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i] != 1.0)
      throw std::invalid_argument(
          fmt::format("coil.current_share_{} must be 1: {} drives all coils alike; got {}", i + 1, what, shares[i]));
}

}  // namespace coilwright::actuator

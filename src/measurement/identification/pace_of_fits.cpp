#include "measurement/identification/pace_of_fits.hpp"

#include <fmt/format.h>

namespace coilwright::measurement::identification {

void PaceOfFits::add(std::size_t fits, Clock::duration took) {
  fits_ += fits;
  took_ += took;
}

std::string PaceOfFits::text(std::size_t more) const {
  constexpr double two_minutes = 120.0;
  if (fits_ == 0) return {};
  const double seconds =
      std::chrono::duration<double>(took_).count() * static_cast<double>(more) / static_cast<double>(fits_);
  if (seconds < 1.0) return ", less than a second";
  if (seconds < two_minutes) return fmt::format(", about {:.0f} s", seconds);
  return fmt::format(", about {:.0f} min", seconds / 60.0);
}

}  // namespace coilwright::measurement::identification

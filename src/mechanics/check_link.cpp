#include "mechanics/check_link.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace coilwright::mechanics {
namespace {

void check(double value, bool valid, int index, const char* field, const char* rule) {
  if (!std::isfinite(value) || !valid)
    throw std::invalid_argument(fmt::format("link {}: {} must be {}; got {}", index, field, rule, value));
}

}  // namespace

void check_link(const Link& link, int index) {
  check(link.length, link.length >= 0.0, index, "length", "finite and >= 0");
  check(link.com_along, true, index, "com_along", "finite");
  check(link.com_offset, true, index, "com_offset", "finite");
  check(link.mass, link.mass > 0.0, index, "mass", "finite and > 0");
  check(link.inertia, link.inertia >= 0.0, index, "inertia", "finite and >= 0");
  check(link.rotor_inertia, link.rotor_inertia >= 0.0, index, "rotor_inertia", "finite and >= 0");
}

}  // namespace coilwright::mechanics

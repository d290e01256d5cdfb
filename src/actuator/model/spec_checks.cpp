#include "actuator/model/spec_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace coilwright::actuator {
namespace {

void check_magnetics(const Model::Spec& spec) {
  const int n = spec.chain.joints();
  const auto require = [](bool valid, const char* rule) {
    if (!valid) throw std::invalid_argument(fmt::format("magnetics: {}", rule));
  };
  for (const HingePair& pair : spec.magnetics.hinge_pairs()) {
    if (pair.joint < 0 || pair.joint >= n || pair.coil < 0 || pair.coil >= spec.coils)
      throw std::invalid_argument(fmt::format("magnetics: joint {} and coil {} must exist", pair.joint, pair.coil));
    require(pair.torque_per_ampere != nullptr, "a hinge pair must have its curve; got none");
  }
  for (const DistantPair& pair : spec.magnetics.distant_pairs()) {
    if (pair.first.link < -1 || pair.second.link <= pair.first.link || pair.second.link >= n)
      throw std::invalid_argument(
          fmt::format("magnetics: links of a distant pair must rise from -1 to {}; got {} and {}", n - 1,
                      pair.first.link, pair.second.link));
    if (pair.coil < -1 || pair.coil >= spec.coils)
      throw std::invalid_argument(
          fmt::format("magnetics: coil of a distant pair must be -1 to {}; got {}", spec.coils - 1, pair.coil));
    if (pair.second_coil < -1 || pair.second_coil >= spec.coils || (pair.coil < 0 && pair.second_coil >= 0))
      throw std::invalid_argument(
          fmt::format("magnetics: second coil of a distant pair must be -1, or beside a first one to {}; got {}",
                      spec.coils - 1, pair.second_coil));
    require(pair.axial_force != nullptr && pair.axial_energy != nullptr,
            "a distant pair must have both its curves; got fewer");
  }
}

}  // namespace

void require_consistent(const Model::Spec& spec) {
  const int n = spec.chain.joints();
  if (static_cast<int>(spec.hinges.size()) != n)
    throw std::invalid_argument(fmt::format("hinges: one per joint, {} here; got {}", n, spec.hinges.size()));
  if (spec.coils < 0) throw std::invalid_argument(fmt::format("coils must be >= 0; got {}", spec.coils));
  if (spec.current_shares.size() != 0 && (spec.current_shares.size() != spec.coils || !spec.current_shares.allFinite()))
    throw std::invalid_argument(
        fmt::format("current_shares: {} finite numbers, or none; got {}", spec.coils, spec.current_shares.size()));
  if (const auto ohm = spec.coil_resistance; ohm && !(std::isfinite(*ohm) && *ohm > 0.0))
    throw std::invalid_argument(fmt::format("coil_resistance must be finite and > 0; got {}", *ohm));
  for (int j = 0; j < n; ++j) {
    const auto require = [&](bool valid, const char* field, double value) {
      if (!valid || !std::isfinite(value))
        throw std::invalid_argument(fmt::format("joint {}: {} must be finite and >= 0; got {}", j, field, value));
    };
    const Hinge& hinge = spec.hinges[j];
    require(hinge.stiffness >= 0.0, "stiffness", hinge.stiffness);
    require(hinge.damping >= 0.0, "damping", hinge.damping);
    require(hinge.contact.stiffness >= 0.0, "contact stiffness", hinge.contact.stiffness);
    require(hinge.contact.damping >= 0.0, "contact damping", hinge.contact.damping);
    if (!std::isfinite(hinge.torque_offset))
      throw std::invalid_argument(
          fmt::format("joint {}: torque_offset must be finite; got {}", j, hinge.torque_offset));
  }
  check_magnetics(spec);
  if (spec.tip.link < -1 || spec.tip.link >= n)
    throw std::invalid_argument(fmt::format("tip: link must be -1 to {}; got {}", n - 1, spec.tip.link));
}

}  // namespace coilwright::actuator

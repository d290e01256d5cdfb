#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::sizing {

/// The limits that pulses set: the load of coils and magnets with the ripple of the study's driver, and the driver's
/// peaks. No other limit of a part includes them. Empty without a driver.
[[nodiscard]] std::vector<simulation::PartLimit> limits_of_pulses(const Study& study, const EvaluatedDesign& design);

/// The limits of parts and pulses that the design breaks, as simulation::broken_part_limits() selects them.
[[nodiscard]] std::vector<simulation::PartLimit> broken_limits(const Study& study, const EvaluatedDesign& design);

/// A limit of coils, magnets or wire that designs break because no limit of their study forbids it.
struct BrokenPartLimit {
  std::string_view quantity{};  ///< "magnet_temperature_degC"
  std::string consequence{};    ///< consequence of exceeding it, as the end of a sentence
  bool conditional = false;     ///< as in simulation::PartLimit
  std::size_t designs{};        ///< number of designs that break it; > 0
};

/// The broken limits of the designs that an answer to `study` recommends, unconditional ones first; empty if all keep
/// all.
[[nodiscard]] std::vector<BrokenPartLimit> broken_part_limits(const Study& study,
                                                              std::span<const DesignResult> designs);

}  // namespace coilwright::sizing

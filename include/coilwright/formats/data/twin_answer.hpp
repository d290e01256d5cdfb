#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The true shift and rate of the clock of a run.
struct ClockOfRun {
  std::string run{};  ///< file of the run
  measurement::planning::TrueClock clock{};
};

/// The hidden effects, noise and clocks of a twin's data.
struct TwinAnswer {
  std::string dataset{};   ///< folder of the data set
  std::string actuator{};  ///< actuator file from which it was made
  std::string experiment{};
  std::span<const actuator::Effect> effects{};
  const measurement::planning::Instruments& instruments;
  std::vector<ClockOfRun> clocks{};  ///< clocks of the runs that have two
  std::uint64_t seed{};
};

/// The content of the answer's file; its keys are in docs/formats-experiment.md.
[[nodiscard]] text::Json to_json(const TwinAnswer& answer);

}  // namespace coilwright::formats

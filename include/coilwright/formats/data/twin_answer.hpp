#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// What the clock of a run really was.
struct ClockOfRun {
  std::string run{};  ///< its file
  measurement::planning::TrueClock clock{};
};

/// What is hidden in the data of a twin, and how they came about.
struct TwinAnswer {
  std::string dataset{};   ///< folder of the data set
  std::string actuator{};  ///< file that it was made from
  std::string experiment{};
  std::span<const actuator::Effect> effects{};
  const measurement::planning::Instruments& instruments;
  std::vector<ClockOfRun> clocks{};  ///< of the runs that have two clocks
  std::uint64_t seed{};
};

/// The answer's file; its keys are in docs/formats-experiment.md.
[[nodiscard]] text::Json to_json(const TwinAnswer& answer);

}  // namespace coilwright::formats

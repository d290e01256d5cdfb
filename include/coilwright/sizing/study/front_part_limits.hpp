#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::sizing {

/// A limit of coils, magnets or wire that designs of a front break, as no limit of the study forbids it.
struct FrontPartLimit {
  std::string_view quantity{};     ///< "magnet_temperature_degC"
  std::string_view consequence{};  ///< what happens beyond it, as the end of a sentence
  std::size_t designs{};           ///< how many of the front break it; > 0
};

/// Evaluates the designs of a front again. In the order of simulation::part_limits(); empty where all keep all.
[[nodiscard]] std::vector<FrontPartLimit> front_part_limits(const DesignProblem& problem,
                                                            std::span<const Record> front);

}  // namespace coilwright::sizing

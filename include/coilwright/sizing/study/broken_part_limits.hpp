#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::sizing {

/// A limit of coils, magnets or wire that designs break, as no limit of their study forbids it.
struct BrokenPartLimit {
  std::string_view quantity{};  ///< "magnet_temperature_degC"
  std::string consequence{};    ///< what happens beyond it, as the end of a sentence
  bool conditional = false;     ///< as in simulation::PartLimit
  std::size_t designs{};        ///< how many break it; > 0
};

/// Of the designs that an answer recommends, unconditional ones first; empty where all keep all.
[[nodiscard]] std::vector<BrokenPartLimit> broken_part_limits(std::span<const DesignResult> designs);

}  // namespace coilwright::sizing

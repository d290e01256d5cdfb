#pragma once

#include <string>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::measurement::identification {

/// One more effect that the data hint at and do not decide, and what it would do to the numbers that are reported.
struct HintedEffect {
  const actuator::EffectKind* kind{};
  double gain{};         ///< of the quasi-BIC that it promises beside the model that is reported, to first order
  std::string number{};  ///< the key of the number whose interval it widens most
  double wider{};        ///< how many times wider that interval is for its sake
};

}  // namespace coilwright::measurement::identification

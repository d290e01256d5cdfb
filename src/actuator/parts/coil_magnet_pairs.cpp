#include "coilwright/actuator/parts/coil_magnet_pairs.hpp"

#include <utility>
#include <vector>

namespace coilwright::actuator {

MagneticStage coil_magnet_pairs(const MagneticStage& magnetics) {
  std::vector<DistantPair> distant;
  for (const DistantPair& pair : magnetics.distant_pairs())
    if (pair.coil >= 0 && pair.second_coil < 0) distant.push_back(pair);
  return {magnetics.hinge_pairs(), std::move(distant)};
}

}  // namespace coilwright::actuator

#include "systems/like_actuators.hpp"

namespace coilwright::systems {

drive::CoilBank of_like_actuators(const drive::CoilBank& one, int count) {
  const Eigen::Index coils = one.resistances.size();
  drive::CoilBank all{.resistances = one.resistances.replicate(count, 1),
                      .inductances = Eigen::MatrixXd::Zero(coils * count, coils * count),
                      .wiring = one.wiring};
  for (int i = 0; i < count; ++i) all.inductances.block(i * coils, i * coils, coils, coils) = one.inductances;
  return all;
}

}  // namespace coilwright::systems

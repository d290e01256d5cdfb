// A step of MuJoCo with friction as Coulomb has it, which may depend on its direction.
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <utility>
#include <vector>

namespace second_engine {

// Friction of all contacts, by the direction of its force.
struct Friction {
  double towards_plus_x{}, towards_minus_x{};
};

// A step, with friction that may depend on its direction, as MuJoCo has it or as Coulomb's.
//
// MuJoCo seeks accelerations a with a - wanted in the dual of the cone of friction: a contact that slides opens, by the
// coefficient of friction times the way that it slides. Coulomb's law is that problem with a normal part that is larger
// by friction times the tangential one (de Saxce and Feng, Math. Comput. Modelling 28 (1998) 225). That of the last
// step is taken, a few steps being what a foot needs to land.
class Stepper {
 public:
  Stepper(const mjModel* model, mjData* data, const Friction& friction);

  void step();

 private:
  void solve();
  [[nodiscard]] std::vector<mjContact*> rubbing() const;
  bool turn();
  void lower();
  void keep();

  const mjModel* model_;
  mjData* data_;
  Friction friction_;
  bool coulomb_;
  std::map<std::pair<int, int>, double> slid_;  // by the two shapes: friction times tangential part, m/s^2
};

}  // namespace second_engine

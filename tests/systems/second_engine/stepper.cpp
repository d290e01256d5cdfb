#include "systems/second_engine/stepper.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "systems/second_engine/scene.hpp"

namespace second_engine {

Stepper::Stepper(const mjModel* model, mjData* data, const Friction& friction)
    : model_(model), data_(data), friction_(friction), coulomb_(number(model, "coulomb") != 0.0) {}

void Stepper::step() {
  mj_step1(model_, data_);
  if (coulomb_) lower();
  solve();
  for (int round = 0; round < 8 && turn(); ++round) solve();
  if (coulomb_) keep();
  mj_Euler(model_, data_);
}

void Stepper::solve() {
  mj_fwdActuation(model_, data_);
  mj_fwdAcceleration(model_, data_);
  mj_fwdConstraint(model_, data_);
}

std::vector<mjContact*> Stepper::rubbing() const {
  std::vector<mjContact*> out;
  for (int c = 0; c < data_->ncon; ++c)
    if (data_->contact[c].dim == 3 && data_->contact[c].efc_address >= 0) out.push_back(data_->contact + c);
  return out;
}

// Gives each contact the coefficient of the direction in which its friction acts on the second shape; whether that
// changes one.
bool Stepper::turn() {
  if (friction_.towards_plus_x == friction_.towards_minus_x) return false;
  bool turned = false;
  for (mjContact* contact : rubbing()) {
    std::array<double, 6> force{};
    mj_contactForce(model_, data_, static_cast<int>(contact - data_->contact), force.data());
    const double along_x = force[1] * contact->frame[3] + force[2] * contact->frame[6];
    if (force[0] <= 0.0 || along_x == 0.0) continue;
    const double friction = along_x > 0.0 ? friction_.towards_plus_x : friction_.towards_minus_x;
    if (friction == contact->friction[0]) continue;
    turned = true;
    contact->mu *= friction / contact->friction[0];  // the same, as the cone's own scale has it
    contact->friction[0] = contact->friction[1] = friction;
  }
  return turned;
}

void Stepper::lower() {
  for (const mjContact* contact : rubbing()) {
    const auto last = slid_.find({contact->geom1, contact->geom2});
    double* wanted = data_->efc_aref + contact->efc_address;
    wanted[0] -= last != slid_.end() ? last->second : contact->friction[0] * std::hypot(wanted[1], wanted[2]);
  }
}

void Stepper::keep() {
  slid_.clear();
  std::vector<double> acceleration(static_cast<std::size_t>(data_->nefc));
  if (data_->nefc > 0) mj_mulJacVec(model_, data_, acceleration.data(), data_->qacc);
  for (const mjContact* contact : rubbing()) {
    const double* wanted = data_->efc_aref + contact->efc_address;
    const double* found = acceleration.data() + contact->efc_address;
    slid_[{contact->geom1, contact->geom2}] =
        contact->friction[0] * std::hypot(found[1] - wanted[1], found[2] - wanted[2]);
  }
}

}  // namespace second_engine

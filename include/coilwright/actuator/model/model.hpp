#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator {

/// History of a model at rest before t = 0: held until every internal state is steady, or as a recorded run begins
/// (which differs only for heat: EffectTerm::begin).
enum class InitialHistory { long_hold, recorded_run };

/// The joints' motion as a camera shows it.
struct ShownMotion {
  mechanics::JointVector angles;  ///< rad
  mechanics::JointVector rates;   ///< rad/s
};

/// An actuator for simulation: the stages drive, magnetics, hinge, chain and camera in a row. Immutable; copies share
/// large parts.
///
/// Effects may have internal states (currents, heat, creep, friction). Static queries (torques, equilibria, stiffness)
/// use the steady values of these states at that pose, unless another InitialHistory is asked for.
class Model {
 public:
  /// Inputs of a Model.
  using Spec = ModelSpec;
  /// Builds the model. Throws std::invalid_argument if counts do not match, a hinge value breaks its rule, or an effect
  /// is given twice, breaks its rules or cannot be in this model.
  explicit Model(Spec spec);

  /// The nominal stages, before effects were built in, and the effects. The other queries (chain(), hinges(),
  /// magnetics()) answer with the effects built in.
  [[nodiscard]] const Spec& nominal_spec() const noexcept { return nominal_ ? *nominal_ : spec_; }

  [[nodiscard]] int joints() const noexcept { return spec_.chain.joints(); }
  [[nodiscard]] int coils() const noexcept { return spec_.coils; }
  [[nodiscard]] const mechanics::PlanarChain& chain() const noexcept { return spec_.chain; }
  [[nodiscard]] const std::vector<Hinge>& hinges() const noexcept { return spec_.hinges; }
  [[nodiscard]] const MagneticStage& magnetics() const noexcept { return spec_.magnetics; }
  [[nodiscard]] const mechanics::LinkPoint& tip() const noexcept { return spec_.tip; }

  /// Whether any effect acts while the model runs.
  [[nodiscard]] bool has_terms() const noexcept { return !terms_.empty(); }
  /// Number of internal states of all effects.
  [[nodiscard]] int internal_states() const noexcept { return internal_states_; }
  /// Number of internal states that belong to the drive. They come first and depend on the command alone, not on the
  /// motion.
  [[nodiscard]] int drive_states() const noexcept { return drive_states_; }
  /// Time constant of the drive's states, s, if they are a single lag (EffectTerm::lag); otherwise 0.
  [[nodiscard]] double drive_lag() const noexcept;
  /// Whether this internal state is the place or the rate of a body that moves beside the chain (EffectTerm::Body).
  [[nodiscard]] bool is_of_a_body(int internal_state) const;
  /// The effects' states at rest at `angles` (rad) under `command` (A).
  [[nodiscard]] InternalStates settled(const mechanics::JointVector& angles, const CoilCurrents& command,
                                       InitialHistory history = InitialHistory::long_hold) const;
  /// The drive's states after a long hold under `command` (A): the first drive_states() of the internal states.
  [[nodiscard]] InternalStates settled_drive(const CoilCurrents& command) const;

  /// The effective currents, A, after a long hold at `angles` (rad) under `command` (A): the coil currents behind the
  /// drive, scaled by the effect of a warm magnet or a gain on their force.
  [[nodiscard]] CoilCurrents strength(const mechanics::JointVector& angles, const CoilCurrents& command) const;

  /// Whether dry friction may hold joints at rest (EffectTerm::holds_joints).
  [[nodiscard]] bool holds_joints() const noexcept { return holds_joints_; }
  /// Sets the states of all dry friction in `internal`, which has all states of this model. `shares` has one value for
  /// each joint: sgn(omega) if it slides, and if it rests the share of its largest torque with which it is held.
  void set_friction(const mechanics::JointVector& shares, std::span<double> internal) const;

  /// Whether an effect moves so slowly that a step response holds it.
  [[nodiscard]] bool has_slow_states() const noexcept;
  /// Returns this model with the states of its slow effects fixed at their values in `internal` (all states of this
  /// model). The result no longer counts them among its states.
  [[nodiscard]] Model with_slow_states_held(const InternalStates& internal) const;

  /// Returns this model with magnets of other strengths, one per magnet (its polarisation over that of the curves).
  /// Fixed states are free again.
  [[nodiscard]] Model with_magnet_strengths(std::span<const double> strengths) const;

  /// Resistance of one coil at 20 degC, ohm; absent for a lumped model.
  [[nodiscard]] std::optional<double> coil_resistance() const noexcept { return spec_.coil_resistance; }
  /// The currents that `voltages` (V, one per coil) drive at 20 degC, A. Quasi-static: L / R of a coil (0.3 ms in the
  /// prototype) is far below a finger's 30 ms, and heat and lag are effects. Throws std::invalid_argument if the
  /// resistance is not known.
  [[nodiscard]] CoilCurrents currents_under(const CoilCurrents& voltages) const;

  /// The currents of all coils at an operating current, A: its share of it for each coil.
  [[nodiscard]] CoilCurrents all_coils(double current) const {
    if (spec_.current_shares.size() == 0) return CoilCurrents::Constant(coils(), current);
    return current * spec_.current_shares;
  }
  /// Share of the operating current that each coil carries, (coils).
  [[nodiscard]] CoilCurrents current_shares() const { return all_coils(1.0); }

  /// Joint torques of magnetics and hinges, N m: everything but gravity and inertia.
  [[nodiscard]] mechanics::JointVector torques(const mechanics::JointVector& angles,
                                               const mechanics::JointVector& rates, const CoilCurrents& currents,
                                               InitialHistory history = InitialHistory::long_hold) const;

  /// Torques of the magnetics alone, at rest under `command` (A), N m: the reading of a torque bench with a bare joint.
  [[nodiscard]] mechanics::JointVector magnetic_torques(const mechanics::JointVector& angles,
                                                        const CoilCurrents& command) const;

  /// Torques of the hinges alone, at rest without current, N m: the reading of a gauge that holds the joints, with its
  /// sign reversed.
  [[nodiscard]] mechanics::JointVector hinge_torques(const mechanics::JointVector& angles) const;

  /// Evaluates the whole equation of motion: accelerations, rad/s^2, and slopes of the effects' states `internal` (each
  /// in its unit per second) under the commanded currents (A) and further joint torques `applied` (N m). The spans of
  /// states have internal_states() entries. `held` marks joints at rest that stay at rest.
  void derivative(const mechanics::JointVector& angles, const mechanics::JointVector& rates,
                  std::span<const double> internal, const CoilCurrents& command, const mechanics::JointVector& applied,
                  mechanics::JointVector& accelerations, std::span<double> internal_slopes,
                  std::span<const int> held = {}) const;

  /// Slopes of the equation of motion about one motion under constant effective currents (A): by_acceleration a =
  /// -by_rate w - by_angle t for small changes t of the angles, w of the rates and a of the accelerations. They are
  /// analytic and leave out the face contacts, which are not smooth. Only for a model without terms (has_terms()).
  [[nodiscard]] mechanics::ChainSlopes slopes_without_contact(const mechanics::JointVector& angles,
                                                              const mechanics::JointVector& rates,
                                                              const mechanics::JointVector& accelerations,
                                                              const CoilCurrents& currents) const;

  /// Sum of torques at rest, N m: zero in an equilibrium.
  [[nodiscard]] mechanics::JointVector static_residual(const mechanics::JointVector& angles,
                                                       const CoilCurrents& currents,
                                                       InitialHistory history = InitialHistory::long_hold) const;

  /// Negative slope of static_residual() by the angles, (n, n), N m/rad. An equilibrium is stable if it is positive
  /// definite.
  [[nodiscard]] mechanics::JointMatrix tangent_stiffness(const mechanics::JointVector& angles,
                                                         const CoilCurrents& currents,
                                                         InitialHistory history = InitialHistory::long_hold) const;

  /// Damping of every joint at rest at `angles`, N m s/rad: that of its hinge, and that of its stop if it is pressed.
  [[nodiscard]] mechanics::JointVector damping(const mechanics::JointVector& angles) const;

  /// Damping of small motions about a pose at rest under currents (A), (n, n), including that of the effects.
  [[nodiscard]] mechanics::JointMatrix damping(const mechanics::JointVector& angles, const CoilCurrents& command) const;

  /// The sum of the joint angles, rad, which a camera without error shows.
  [[nodiscard]] static double bending_angle(const mechanics::JointVector& angles) { return angles.sum(); }

  /// The joints' angles and rates as a camera that filters shows them; without a filter they are the true ones. Scale,
  /// offset and delay are not included: pass an angle, or a sum of angles, to observed(). `internal` has all states of
  /// the effects.
  [[nodiscard]] ShownMotion shown(const mechanics::JointVector& angles, const mechanics::JointVector& rates,
                                  std::span<const double> internal) const;
  /// Whether shown() may differ from the motion: EffectTerm::shows().
  [[nodiscard]] bool camera_filters() const noexcept { return camera_filters_; }
  /// The angle that the camera shows for the bending angle, or for a single joint's angle, rad.
  [[nodiscard]] double observed(double angle) const;
  /// Delay of what the camera shows, s; negative if records are stamped too early.
  [[nodiscard]] double delay() const;

 private:
  // An effect at work, and where its states are: among those of the model, or held.
  struct Term {
    std::shared_ptr<const EffectTerm> effect;
    Stage stage{};
    bool held{};
    int first{};
  };
  [[nodiscard]] EffectTerm::InternalStateView own(const Term& term, const double* states, double* slopes) const;
  void number_states();
  // Terms of the stages drive, magnetics and hinge to chain, in this order, and of the camera last.
  [[nodiscard]] std::span<const Term> terms(Stage first, Stage last) const;

  // The states of one term where they begin: settled() above.
  void settle(const Term& term, const EffectTerm::Kinematics& motion, const CoilCurrents& entering,
              InitialHistory history, double* states) const;
  // The same of every term of the drive; what it lets through, A.
  CoilCurrents settle_drive(const EffectTerm::Kinematics& motion, CoilCurrents currents, InitialHistory history,
                            double* states) const;
  // Effective currents, A: see strength() above.
  [[nodiscard]] CoilCurrents strength(const CoilCurrents& command, const double* states, double* slopes) const;
  // Of the hinges but for the terms; writes every joint.
  void own_hinge_torques(const mechanics::JointVector& angles, const mechanics::JointVector& rates,
                         mechanics::JointVector& torques) const;
  // Of magnetics and hinges but for the terms; writes every joint.
  void stage_torques(const mechanics::JointVector& angles, const mechanics::JointVector& rates,
                     const CoilCurrents& strength, mechanics::JointVector& torques) const;
  void add_term_torques(const EffectTerm::Kinematics& motion, const CoilCurrents& strength, const double* states,
                        double* slopes, mechanics::JointVector& torques) const;
  // Moves the effects' bodies with the chain of that mass matrix: corrects `accelerations`, which the chain would have
  // without them, and writes the slopes of the bodies' states.
  void accelerate_bodies(const EffectTerm::Kinematics& motion, const CoilCurrents& strength, const double* states,
                         double* slopes, std::span<const int> held, const mechanics::JointMatrix& mass,
                         mechanics::JointVector& accelerations) const;
  // As shown(); null: no slopes.
  [[nodiscard]] ShownMotion shown(const mechanics::JointVector& angles, const mechanics::JointVector& rates,
                                  const double* states, double* slopes) const;
  void add_term_stiffness(const mechanics::JointVector& angles, const CoilCurrents& command, InitialHistory history,
                          mechanics::JointMatrix& stiffness) const;

  Spec spec_;                                 // with the effects built in
  std::shared_ptr<const Spec> nominal_;       // without; null where there are none
  std::vector<Term> terms_;                   // in the order of their stages
  std::array<std::size_t, 6> stage_begin_{};  // where the terms of each stage begin, and those of the last end
  std::vector<double> held_;                  // states that are held
  int internal_states_ = 0;
  int drive_states_ = 0;
  int camera_states_ = 0;
  bool camera_filters_ = false;
  bool holds_joints_ = false;
  int bodies_ = 0;
};

}  // namespace coilwright::actuator

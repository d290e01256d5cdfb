#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator {

/// History of a model at rest before t = 0: held until every internal state is steady, or as a recorded run finds it
/// (which differs for heat alone: see EffectTerm::begin).
enum class InitialHistory { long_hold, recorded_run };

/// What a camera shows of the joints.
struct ShownMotion {
  mechanics::JointVector angles;  ///< rad
  mechanics::JointVector rates;   ///< rad/s
};

/// An actuator for simulation: drive, magnetics, hinge, chain, camera in a row. Immutable; copies share what is large.
///
/// Effects may carry states of their own (currents, heat, creep, friction). Static queries (torques, equilibria,
/// stiffness) use the steady values of all these states at that pose, unless another InitialHistory is asked for.
class Model {
 public:
  /// Inputs of a Model.
  using Spec = ModelSpec;
  /// Throws std::invalid_argument where counts do not match, a hinge value breaks its rule, or an effect is given
  /// twice, breaks its rules or cannot be in this model.
  explicit Model(Spec spec);

  /// What it was made of: the nominal stages, before any effect was built in, and the effects. The other queries
  /// (chain(), hinges(), magnetics()) answer with the effects built in.
  [[nodiscard]] const Spec& nominal_spec() const noexcept { return nominal_ ? *nominal_ : spec_; }

  [[nodiscard]] int joints() const noexcept { return spec_.chain.joints(); }
  [[nodiscard]] int coils() const noexcept { return spec_.coils; }
  [[nodiscard]] const mechanics::PlanarChain& chain() const noexcept { return spec_.chain; }
  [[nodiscard]] const std::vector<Hinge>& hinges() const noexcept { return spec_.hinges; }
  [[nodiscard]] const MagneticStage& magnetics() const noexcept { return spec_.magnetics; }
  [[nodiscard]] const mechanics::LinkPoint& tip() const noexcept { return spec_.tip; }

  /// Whether any effect acts while the model runs.
  [[nodiscard]] bool has_terms() const noexcept { return !terms_.empty(); }
  /// How many states of their own the effects have.
  [[nodiscard]] int internal_states() const noexcept { return internal_states_; }
  /// How many of these belong to the drive; they come first and follow from the command alone, not from the motion.
  [[nodiscard]] int drive_states() const noexcept { return drive_states_; }
  /// The time constant of the drive's states, s, where they are one lag and nothing else (EffectTerm::lag); else 0.
  [[nodiscard]] double drive_lag() const noexcept;
  /// Whether that one of them is the place or the rate of a body that moves beside the chain (EffectTerm::Body).
  [[nodiscard]] bool is_of_a_body(int internal_state) const;
  /// The effects' states at rest at `angles` (rad) under `command` (A).
  [[nodiscard]] InternalStates settled(const mechanics::JointVector& angles, const CoilCurrents& command,
                                       InitialHistory history = InitialHistory::long_hold) const;
  /// The drive's states among them after a long hold: (drive_states()).
  [[nodiscard]] InternalStates settled_drive(const CoilCurrents& command) const;

  /// The effective currents, A, after a long hold at `angles` (rad) under `command` (A): the coil currents that the
  /// drive lets through, scaled by what a warm magnet or a gain does to their force.
  [[nodiscard]] CoilCurrents strength(const mechanics::JointVector& angles, const CoilCurrents& command) const;

  /// Whether dry friction may hold joints at rest (EffectTerm::holds_joints).
  [[nodiscard]] bool holds_joints() const noexcept { return holds_joints_; }
  /// Sets the states of all dry friction in `internal`, all states of this model: of each joint sgn(omega) where it
  /// slides, the share of its largest torque with which it is held where it rests.
  void set_friction(const mechanics::JointVector& shares, std::span<double> internal) const;

  /// Whether an effect moves so slowly that a step response is taken with it held.
  [[nodiscard]] bool has_slow_states() const noexcept;
  /// This model with the states of its slow effects held for good where `internal` (all states of this model) has them;
  /// they are no longer among the states of the result.
  [[nodiscard]] Model with_slow_states_held(const InternalStates& internal) const;

  /// This model with magnets of other strengths, one per magnet (polarisation over that of its curves). States that
  /// were held are free again.
  [[nodiscard]] Model with_magnet_strengths(std::span<const double> strengths) const;

  /// Resistance of one coil at 20 degC, ohm; nothing for a lumped model.
  [[nodiscard]] std::optional<double> coil_resistance() const noexcept { return spec_.coil_resistance; }
  /// The currents that `voltages` (V, one a coil) drive at 20 degC, A: the nominal drive under a voltage. Quasi-static:
  /// L / R of a coil (0.3 ms in the prototype) is far below a finger's 30 ms; heat and lag are effects. Throws
  /// std::invalid_argument where the resistance is not known.
  [[nodiscard]] CoilCurrents currents_under(const CoilCurrents& voltages) const;

  /// The currents of all coils at an operating current, A: the same in every one, on one driver, or its share of it.
  [[nodiscard]] CoilCurrents all_coils(double current) const {
    if (spec_.current_shares.size() == 0) return CoilCurrents::Constant(coils(), current);
    return current * spec_.current_shares;
  }
  /// What each coil carries of the operating current, (coils).
  [[nodiscard]] CoilCurrents current_shares() const { return all_coils(1.0); }

  /// Joint torques of magnetics and hinges, N m: everything but gravity and inertia.
  [[nodiscard]] mechanics::JointVector torques(const mechanics::JointVector& angles,
                                               const mechanics::JointVector& rates, const CoilCurrents& currents,
                                               InitialHistory history = InitialHistory::long_hold) const;

  /// Of the magnetics alone, at rest under `command` (A), N m: what a torque bench with a bare joint reads.
  [[nodiscard]] mechanics::JointVector magnetic_torques(const mechanics::JointVector& angles,
                                                        const CoilCurrents& command) const;

  /// Of the hinges alone, at rest without current, N m: what a gauge that holds the joints reads, with its sign turned.
  [[nodiscard]] mechanics::JointVector hinge_torques(const mechanics::JointVector& angles) const;

  /// The whole equation of motion: accelerations, rad/s^2, and slopes of the effects' states `internal` (each in its
  /// unit a second) under the commanded currents (A) and further joint torques `applied` (N m). The spans of states
  /// have internal_states() entries. `held`: joints at rest that stay so, whatever holds them.
  void derivative(const mechanics::JointVector& angles, const mechanics::JointVector& rates,
                  std::span<const double> internal, const CoilCurrents& command, const mechanics::JointVector& applied,
                  mechanics::JointVector& accelerations, std::span<double> internal_slopes,
                  std::span<const int> held = {}) const;

  /// Slopes of the equation of motion about one motion under constant effective currents (A), so that
  /// by_acceleration a = -by_rate w - by_angle t for small changes t of the angles, w of the rates and a of the
  /// accelerations. Analytic. Without the face contacts, which are no smooth function: whoever follows a motion knows
  /// which of them push. For a model without terms (has_terms()).
  [[nodiscard]] mechanics::ChainSlopes slopes_without_contact(const mechanics::JointVector& angles,
                                                              const mechanics::JointVector& rates,
                                                              const mechanics::JointVector& accelerations,
                                                              const CoilCurrents& currents) const;

  /// Torque left over at rest, N m: zero in an equilibrium.
  [[nodiscard]] mechanics::JointVector static_residual(const mechanics::JointVector& angles,
                                                       const CoilCurrents& currents,
                                                       InitialHistory history = InitialHistory::long_hold) const;

  /// -d(static residual)/d(angle), (n, n), N m/rad; an equilibrium is stable where it is positive definite.
  [[nodiscard]] mechanics::JointMatrix tangent_stiffness(const mechanics::JointVector& angles,
                                                         const CoilCurrents& currents,
                                                         InitialHistory history = InitialHistory::long_hold) const;

  /// Damping of every joint at rest at `angles`, N m s/rad: of its hinge, and of its stop where that is pressed.
  [[nodiscard]] mechanics::JointVector damping(const mechanics::JointVector& angles) const;

  /// The same as (n, n) under currents (A), with what the effects add: of small motions about a pose at rest.
  [[nodiscard]] mechanics::JointMatrix damping(const mechanics::JointVector& angles, const CoilCurrents& command) const;

  /// The sum of the joint angles, rad: what a camera without error shows.
  [[nodiscard]] static double bending_angle(const mechanics::JointVector& angles) { return angles.sum(); }

  /// What a camera that filters shows of the joints in a state: their angles and rates as they are where it does not.
  /// Its scale, offset and delay are not in it: pass an angle, or a sum of angles, to observed(). `internal` are all
  /// states of the effects.
  [[nodiscard]] ShownMotion shown(const mechanics::JointVector& angles, const mechanics::JointVector& rates,
                                  std::span<const double> internal) const;
  /// Whether shown() may differ from the motion: EffectTerm::shows().
  [[nodiscard]] bool camera_filters() const noexcept { return camera_filters_; }
  /// What the camera shows of an angle, rad: of the bending angle, or of a single joint's.
  [[nodiscard]] double observed(double angle) const;
  /// How long ago the motion was that the camera shows now, s; below zero where records are stamped too early.
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

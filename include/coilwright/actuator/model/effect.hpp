#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/parts/coil_currents.hpp"
#include "coilwright/mechanics/joint_vector.hpp"
#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator {

struct ModelSpec;

/// The largest number of internal states of all effects of a model together.
inline constexpr int max_internal_states = 128;
/// States of the effects, in the order of the effects: currents, heat, creep, friction, each in its own unit.
using InternalStates = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_internal_states, 1>;

/// The largest number of moving bodies of all effects of a model together.
inline constexpr int max_bodies = mechanics::max_joints + 4;

/// The stages of a model, in the order in which a command passes them. An effect belongs to exactly one.
enum class Stage { drive, magnetics, hinge, chain, camera };

/// Characteristic magnitudes of the measured motion; effects derive their initial guesses from them.
struct RigScale {
  double torque{};       ///< of the joints' own torques over the motion, N m; > 0
  double angle{};        ///< of the motion, rad; > 0
  double rate{};         ///< rad/s; > 0
  double current{};      ///< A; 0 for a rig without coils
  double interval{};     ///< between samples, s; > 0
  double duration{};     ///< of the longest run, s; > 0
  double mean_angle{};   ///< of a joint over the motion, rad
  double upper_angle{};  ///< largest angle of a joint, rad
  double lower_angle{};  ///< smallest, rad
};

/// One number of an effect.
struct EffectParameter {
  std::string_view key;   ///< as files write it, unit at its end: "torque_Nmm"; no unit for a pure number
  std::string_view text;  ///< its meaning, one line
  double lower{};         ///< physical bounds, SI, inclusive; may be infinite
  double upper{};
  /// The value at which the effect is absent, SI. A shape (a time constant, a range) that means nothing without another
  /// parameter has none.
  std::optional<double> absent{};
  /// The values that the number may take instead of a range (the side of a stop). A fit tries each. Empty: a range.
  std::span<const double> choices{};
  /// Standard deviation of a normal prior about `absent`, SI, > 0, for one of many numbers of a smooth function.
  /// Absent: the number is free within its bounds, as those of physical effects are.
  std::optional<double> deviation{};
};

/// The action of an effect while the model runs: hooks into the stages. Each effect overrides the hooks of its own
/// stage. Immutable and shared between threads; whatever changes in time is in its InternalStateView.
class EffectTerm {
 public:
  EffectTerm() = default;
  EffectTerm(const EffectTerm&) = delete;
  EffectTerm& operator=(const EffectTerm&) = delete;
  virtual ~EffectTerm() = default;

  /// A pose and its rates, with the chain that they belong to.
  struct Kinematics {
    const mechanics::PlanarChain& chain;
    const mechanics::JointVector& angles;  ///< rad
    const mechanics::JointVector& rates;   ///< rad/s
    /// Joint torques that are commanded beside the currents, N m; null if there are none.
    const mechanics::JointVector* applied = nullptr;
  };
  /// The effect's own part of the model's internal states, and the place for their slopes; null if no slopes are
  /// wanted.
  struct InternalStateView {
    const double* states{};
    double* slopes{};
  };

  /// Number of internal states of the effect.
  [[nodiscard]] virtual int states() const { return 0; }
  /// Whether these states move so slowly (heat, creep over many seconds) that a step response holds them.
  [[nodiscard]] virtual bool slow() const { return false; }
  /// Writes the states after a long hold at `motion` (at rest) under `currents`, as these enter its stage. Default:
  /// zeros.
  virtual void settle(const Kinematics& motion, const CoilCurrents& currents, double* states) const;
  /// Writes the states with which a recorded run begins that starts at rest. Default: settled. Heat may be cold
  /// instead.
  virtual void begin(const Kinematics& motion, const CoilCurrents& currents, double* states) const {
    settle(motion, currents, states);
  }

  /// Drive: turns the currents that enter the stage into those that leave it.
  virtual void drive(InternalStateView own, CoilCurrents& currents) const;
  /// Drive: the time constant T of a lag, s, if the states are the currents that leave, x' = (entering - x) / T. An
  /// integrator then has them in closed form while the command is held or follows a curve. 0 for states of any other
  /// kind.
  [[nodiscard]] virtual double lag() const { return 0.0; }
  /// Magnetics: changes `strength`, the effective currents, in proportion to the force (a weaker magnet is a smaller
  /// current).
  virtual void magnetize(InternalStateView own, const CoilCurrents& currents, CoilCurrents& strength) const;
  /// Magnetics, hinge and chain: adds joint torques, N m, opening positive.
  virtual void add_torques(const Kinematics& motion, const CoilCurrents& strength, InternalStateView own,
                           mechanics::JointVector& torques) const;
  /// Magnetics, hinge and chain: whether the effect is dry friction, which may hold a joint at rest. Then it has one
  /// state y for each joint, and its torque is linear in y: y = sgn(omega) on a sliding joint, any y from -1 to 1 on a
  /// joint at rest. Whoever follows a motion sets the states (Model::set_friction); their slopes are zero.
  [[nodiscard]] virtual bool holds_joints() const { return false; }
  /// Adds the damping of small motions about a pose at rest, N m s/rad, to `damping` (n, n).
  virtual void add_damping(const Kinematics& motion, const CoilCurrents& strength,
                           mechanics::JointMatrix& damping) const;

  /// Bodies of its own that move beside the chain: a mount, a loose magnet. A body has one coordinate u, its mass m, a
  /// coupling c to the joints' accelerations and a force f on it:
  ///   M theta'' + c u'' = joint torques,  c . theta'' + m u'' = f,  with m > c . M^-1 c at every pose.
  /// Of the effect's states the coordinates come first, then their rates; the model writes the slopes of both.
  struct Body {
    mechanics::JointVector coupling;  ///< c, kg m for a coordinate in m, kg m^2 for one in rad
    double mass{};                    ///< m, kg or kg m^2; > 0
    double force{};                   ///< f, N or N m, without the part of c . theta''
  };
  /// Number of bodies that move beside the chain; each has two states. A model has at most max_bodies.
  [[nodiscard]] virtual int bodies() const { return 0; }
  /// Writes bodies() bodies to `out`; the coupling of each is zero on entry. `states` are the effect's own.
  virtual void describe_bodies(const Kinematics& motion, const CoilCurrents& strength, const double* states,
                               Body* out) const;

  /// Camera: turns the joints' angles (rad) and rates (rad/s) into those shown, before scale and offset. Writes the
  /// slopes of its states if they are wanted.
  virtual void show(InternalStateView own, mechanics::JointVector& angles, mechanics::JointVector& rates) const;
  /// Camera: whether show() changes anything. Default: whether the effect has states.
  [[nodiscard]] virtual bool shows() const { return states() > 0; }
  /// Camera: the angle that it shows for an angle, rad.
  [[nodiscard]] virtual double observed(double angle) const { return angle; }
  /// Camera: delay of what it shows, s; negative if records are stamped too early.
  [[nodiscard]] virtual double delay() const { return 0.0; }
};

/// A physical effect that a model may lack: its name, its numbers, and the way to build it in. Immutable and used from
/// several threads at once. Effect, EffectCatalogue, Model and Diagnosis refer to it by its address, so each kind must
/// outlive all of them; static storage is best.
class EffectKind {
 public:
  EffectKind() = default;
  EffectKind(const EffectKind&) = delete;
  EffectKind& operator=(const EffectKind&) = delete;
  virtual ~EffectKind() = default;

  /// The name in measured-data/1: "dry_friction".
  [[nodiscard]] virtual std::string_view id() const = 0;
  /// The stage to which the effect belongs.
  [[nodiscard]] virtual Stage stage() const = 0;
  /// The physical cause, in one line for people: "a warm coil resists more, so its current fades".
  [[nodiscard]] virtual std::string_view description() const = 0;
  /// Its equation, one line of plain text.
  [[nodiscard]] virtual std::string_view equation() const = 0;
  /// Source of the equation.
  [[nodiscard]] virtual std::string_view source() const = 0;
  /// A check at the rig by which a person finds out, in minutes and without this model, whether the effect is there:
  /// one line in the imperative, without a full stop. Empty if there is no such check.
  [[nodiscard]] virtual std::string_view check() const { return {}; }
  /// The numbers of the effect; empty for an effect that is only there or not.
  [[nodiscard]] virtual std::span<const EffectParameter> parameters() const = 0;

  /// Whether the effect is gone while the coils' circuit is open, as a driver's bias or an induced current is.
  [[nodiscard]] virtual bool needs_closed_circuit() const { return false; }

  /// The same effect, by the same id, with further numbers after its own that mean nothing without it, such as
  /// Stribeck's fall of dry friction; null if there is none. Files name all of them or none. A search should try it
  /// only after the plain effect was found. EffectParameter::absent also says where the further numbers mean nothing.
  [[nodiscard]] virtual const EffectKind* with_further_numbers() const { return nullptr; }

  /// Why the effect cannot be in this model (no coils, one joint only, already exact), in one line; absent if it can.
  [[nodiscard]] virtual std::optional<std::string> inapplicable(const ModelSpec& spec) const;
  /// Parameter values from which a fit on such a rig should start, SI: at least one vector, inside the bounds, not
  /// absent.
  [[nodiscard]] virtual std::vector<std::vector<double>> starts(const RigScale& scale) const = 0;
  /// Builds the effect into a model: changes what is fixed in `spec` (a chain, a spring), or returns a term that acts
  /// while the model runs, or both. `values` are SI, one per parameter, inside the bounds. May return null.
  [[nodiscard]] virtual std::unique_ptr<const EffectTerm> build(std::span<const double> values,
                                                                ModelSpec& spec) const = 0;
};

/// An effect with the values of its numbers.
struct Effect {
  const EffectKind* kind{};    ///< not owned: lives longer than every effect, model and result that refers to it
  std::vector<double> values;  ///< SI, one per parameter
};

/// Throws std::invalid_argument naming effect, parameter, rule and value if the number of values is wrong, or if a
/// value is not finite, outside its bounds or not among its choices.
void validate_effect(const Effect& effect);

}  // namespace coilwright::actuator

#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::actuator {

struct ModelSpec;

/// The variables on which a correction of the torque may depend: the angle (rad) or rate (rad/s) of the joint itself,
/// or the effective current (A) of the coil at it; the mean of all coils at a joint without a coil.
enum class CorrectionVariable { angle, rate, current };

/// The name of a variable: "angle", "rate", "current".
[[nodiscard]] std::string_view name_of(CorrectionVariable variable);

/// One variable of a correction, and the values at which its torque is given.
struct CorrectionAxis {
  CorrectionVariable variable{};
  std::vector<double> nodes{};  ///< SI, increasing; at least 3. The correction is valid from the first to the last
  /// Scale of a variable that matters in all its orders of magnitude, such as a rate, SI, > 0: the torque is smooth
  /// over asinh(x / linear_below). Absent: it is smooth over the variable itself.
  std::optional<double> linear_below{};
  friend bool operator==(const CorrectionAxis&, const CorrectionAxis&) = default;
};

/// A torque without a name that a fit found, given at nodes over one or two variables and added to the joints. Between
/// the nodes it is the natural cubic spline in each variable. Beyond the first and the last node, where nothing was
/// measured, it continues straight and fades to zero within `fading_share` of the range; it is twice differentiable
/// everywhere.
struct TorqueCorrection {
  std::vector<CorrectionAxis> axes{};  ///< one or two, of different variables
  std::vector<double>
      torques{};  ///< N m, opening positive, in rows: for each node of the first axis all nodes of the second
  std::optional<int> joint{};  ///< index of the only joint that has it; absent: every joint has the same
  friend bool operator==(const TorqueCorrection&, const TorqueCorrection&) = default;
};

/// Width over which a correction fades beyond a variable's range, as a share of that range, in the coordinate over
/// which it is smooth.
inline constexpr double fading_share = 0.1;

/// Throws std::invalid_argument naming the rule and the value, unless there are one or two different variables with at
/// least 3 finite, increasing nodes each, `linear_below` is finite and > 0, and there are as many finite torques as
/// nodes.
void validate(const TorqueCorrection& correction);

/// Such a torque, prepared for evaluation. Immutable.
class TorqueSurface {
 public:
  /// Throws as validate().
  explicit TorqueSurface(const TorqueCorrection& correction);

  /// Torque, N m, and its slopes with respect to the variables of the axes, N m per SI unit. The second slope is 0
  /// where there is one axis.
  struct Value {
    double torque{};
    double slopes[2]{};
  };
  /// The torque at `first` and `second`, the values of the variables in the order of the axes, SI.
  [[nodiscard]] Value at(double first, double second) const;

 private:
  // The nodes in the coordinate over which the spline is smooth.
  struct Axis {
    std::vector<double> at;
    std::optional<double> linear_below;
    [[nodiscard]] double coordinate(double x) const;
    [[nodiscard]] double slope(double x) const;  // of that coordinate
  };
  struct Weights;
  std::vector<Axis> axes_;
  // For every node the value, its second derivatives along each axis, and the fourth along both.
  std::vector<double> values_, along_first_, along_second_, along_both_;
};

/// Makes the term of a correction for a model with the stages of `spec`. Its stage is Stage::chain, because nobody
/// knows to which stage it belongs. Throws std::invalid_argument as validate(), and if it needs a coil or a joint that
/// the model lacks.
[[nodiscard]] std::unique_ptr<const EffectTerm> correction_term(const TorqueCorrection& correction,
                                                                const ModelSpec& spec);

}  // namespace coilwright::actuator

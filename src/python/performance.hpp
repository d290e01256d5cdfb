#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/simulation/performance.hpp"

namespace coilwright::python {

/// The motion of a lumped model at a current.
struct LumpedPerformance {
  simulation::MotionSummary motion;
  double current{};  ///< A
};

/// What an actuator does at an operating point, as Python holds it: it refers to nothing outside itself.
class Performance {
 public:
  explicit Performance(simulation::EvaluatedDesign evaluated)
      : content_(std::make_shared<const simulation::EvaluatedDesign>(std::move(evaluated))) {}
  explicit Performance(LumpedPerformance lumped) : content_(std::move(lumped)) {}

  /// A quantity in the unit of its name; nothing where it has no value. Throws std::invalid_argument for a name that
  /// there is none of.
  [[nodiscard]] std::optional<double> value(const std::string& name) const;
  /// The design with all that is known of it; nullptr for a lumped model.
  [[nodiscard]] const simulation::EvaluatedDesign* evaluated() const;
  [[nodiscard]] const LumpedPerformance* lumped() const { return std::get_if<LumpedPerformance>(&content_); }

 private:
  std::variant<std::shared_ptr<const simulation::EvaluatedDesign>, LumpedPerformance> content_;
};

}  // namespace coilwright::python

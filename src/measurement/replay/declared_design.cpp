#include "coilwright/measurement/replay/declared_design.hpp"

#include <utility>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/hinges.hpp"
#include "measurement/replay/lru_memo.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::Design;
using actuator::Hinge;
using actuator::ModelSpec;

// Gravity and the tilt of the base change the chain alone.
bool only_hangs_otherwise(const DesignParameter& number) {
  return number.parameter == actuator::find_parameter("gravity_m_s2") ||
         number.parameter == actuator::find_parameter("base_tilt_deg");
}

// The design without what differs from it, which as_built() adds.
Design as_drawn(Design design) {
  design.as_built = {};
  return design;
}

bool needs_reassembly(const DesignTarget& target) {
  if (const auto* number = std::get_if<DesignParameter>(&target)) return !only_hangs_otherwise(*number);
  return std::holds_alternative<MeasuredNumber>(target);
}

}  // namespace

class DeclaredDesign::State {
 public:
  State(Design design, actuator::Measured measured, ModelSpec assembled,
        std::vector<CalibratableNumber<DesignTarget>> numbers)
      : design_(std::move(design)), measured_(measured), numbers_(std::move(numbers)) {
    std::vector<double> declared;
    for (const auto& number : numbers_)
      if (needs_reassembly(number.target)) declared.push_back(number.parameter.declared);
    (void)assembled_.get(declared, [&] { return std::move(assembled); });
  }

  [[nodiscard]] std::vector<CalibrationParameter> parameters() const { return parameters_of(numbers_); }

  [[nodiscard]] ModelSpec spec_at(std::span<const double> values) {
    const Design design = without_hinges(values);
    ModelSpec spec = *assembled_at(design, values);
    spec.chain = spec.chain.under_gravity(design.surroundings.gravity, design.surroundings.base_tilt);
    spec.effects = design.effects;
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      if (const auto* number = std::get_if<HingesNumber>(&numbers_[i].target))
        for (Hinge& hinge : spec.hinges) hinge.*number->member = values[i];
    return actuator::as_built(std::move(spec), design.as_built);
  }

  [[nodiscard]] Design design_at(std::span<const double> values) {
    Design design = without_hinges(values);
    const std::shared_ptr<const ModelSpec> spec = assembled_at(design, values);
    Hinge hinge = spec->hinges.front();
    bool moved = false;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const auto* number = std::get_if<HingesNumber>(&numbers_[i].target);
      if (number == nullptr) continue;
      hinge.*number->member = values[i];
      moved = true;
    }
    return moved ? actuator::with_measured_hinge(std::move(design), hinge.stiffness, hinge.damping) : design;
  }

 private:
  // The design with all values but those of its hinges.
  Design without_hinges(std::span<const double> values) {
    require_values(values, numbers_.size());
    Design design = calibrated_at(values);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      if (const auto* number = std::get_if<DesignParameter>(&numbers_[i].target))
        number->parameter->set(design, values[i]);
      if (const auto* number = std::get_if<EffectNumber>(&numbers_[i].target))
        design.effects[number->effect].values[number->parameter] = values[i];
      if (const auto* number = std::get_if<ForceCurveNumber>(&numbers_[i].target))
        set_number(design.as_built, *number, values[i]);
      if (const auto* number = std::get_if<AsBuiltNumber>(&numbers_[i].target))
        set_number(design.as_built, *number, values[i]);
    }
    return design;
  }

  // The declared design, calibrated by other measured values.
  Design calibrated_at(std::span<const double> values) {
    actuator::Measured measured = measured_;
    std::vector<double> moved;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const auto* number = std::get_if<MeasuredNumber>(&numbers_[i].target);
      if (number == nullptr) continue;
      measured.*number->member = values[i];
      moved.push_back(values[i]);
    }
    Design design = design_;
    if (!moved.empty()) design.calibration = *calibrations_.get(moved, [&] { return calibration_by(measured); });
    return design;
  }

  [[nodiscard]] actuator::Calibration calibration_by(const actuator::Measured& measured) const {
    return actuator::calibrate(design_, measured);
  }

  std::shared_ptr<const ModelSpec> assembled_at(const Design& design, std::span<const double> values) {
    std::vector<double> moved;
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      if (needs_reassembly(numbers_[i].target)) moved.push_back(values[i]);
    return assembled_.get(moved, [&] { return actuator::assemble_or_throw(as_drawn(design)).model.nominal_spec(); });
  }

  Design design_;
  actuator::Measured measured_;
  std::vector<CalibratableNumber<DesignTarget>> numbers_;
  LruMemo<actuator::Calibration> calibrations_;
  LruMemo<ModelSpec> assembled_;
};

DeclaredDesign::DeclaredDesign(Design design, actuator::Measured measured, ModelSpec assembled,
                               std::vector<CalibratableNumber<DesignTarget>> numbers)
    : state_(std::make_shared<State>(std::move(design), measured, std::move(assembled), std::move(numbers))) {}

std::vector<CalibrationParameter> DeclaredDesign::parameters() const {
  return state_->parameters();
}

ModelSpec DeclaredDesign::spec_at(std::span<const double> values) const {
  return state_->spec_at(values);
}

Design DeclaredDesign::design_at(std::span<const double> values) const {
  return state_->design_at(values);
}

}  // namespace coilwright::measurement::replay

#include "coilwright/measurement/replay/declared_lumped_model.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "measurement/replay/lru_memo.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::HingePair;
using actuator::LumpedMagnetics;
using actuator::LumpedModel;
using actuator::ModelSpec;

bool is_magnetic(const LumpedNumber& number) {
  return std::holds_alternative<PartNumber<magnetics::ThickCoil::Spec>>(number) ||
         std::holds_alternative<PartNumber<magnetics::CylinderMagnet::Spec>>(number) ||
         std::holds_alternative<PartNumber<magnetics::HingeGeometry>>(number) ||
         std::holds_alternative<TableNumber>(number);
}

bool moves_coils(const LumpedNumber& number) {
  const auto* link = std::get_if<PartNumber<mechanics::Link>>(&number);
  return is_magnetic(number) || (link != nullptr && link->member == &mechanics::Link::length);
}

bool any_of(const LumpedTarget& target, bool (*is)(const LumpedNumber&)) {
  const auto* shares = std::get_if<LumpedShares>(&target);
  return shares != nullptr && std::ranges::any_of(shares->each, is, &LumpedShare::number);
}

// Puts a value where it belongs.
struct Setter {
  LumpedModel& model;
  double value{};

  void operator()(const LumpedShares& shares) const {
    for (const LumpedShare& share : shares.each) number_in(model, share.number) = value * share.ratio;
  }
  void operator()(const ForceCurveNumber& number) const { set_number(model.as_built, number, value); }
  void operator()(const AsBuiltNumber& number) const { set_number(model.as_built, number, value); }
};

}  // namespace

class DeclaredLumpedModel::State {
 public:
  State(LumpedModel model, LumpedMagnetics magnetics, std::vector<CalibratableNumber<LumpedTarget>> numbers)
      : model_(std::move(model)), magnetics_(std::move(magnetics)), numbers_(std::move(numbers)) {
    for (const auto& number : numbers_) coils_move_ = coils_move_ || any_of(number.target, &moves_coils);
  }

  [[nodiscard]] std::vector<CalibrationParameter> parameters() const { return parameters_of(numbers_); }

  [[nodiscard]] LumpedModel model_at(std::span<const double> values) const {
    require_values(values, numbers_.size());
    LumpedModel model = model_;
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      std::visit(Setter{.model = model, .value = values[i]}, numbers_[i].target);
    return model;
  }

  [[nodiscard]] ModelSpec spec_at(std::span<const double> values) {
    const LumpedModel model = model_at(values);
    std::vector<double> magnetic;
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      if (any_of(numbers_[i].target, &is_magnetic)) magnetic.push_back(values[i]);
    LumpedMagnetics magnetics = magnetics_;
    if (!magnetic.empty())
      magnetics.hinge_pairs = *pairs_.get(magnetic, [&] { return actuator::hinge_pairs_of(model.pairs); });
    if (coils_move_) magnetics.coil_row = actuator::coil_row_of(model);
    return actuator::spec_of(model, magnetics);
  }

 private:
  LumpedModel model_;
  LumpedMagnetics magnetics_;
  std::vector<CalibratableNumber<LumpedTarget>> numbers_;
  bool coils_move_ = false;
  LruMemo<std::vector<HingePair>> pairs_;
};

DeclaredLumpedModel::DeclaredLumpedModel(LumpedModel model, LumpedMagnetics magnetics,
                                         std::vector<CalibratableNumber<LumpedTarget>> numbers)
    : state_(std::make_shared<State>(std::move(model), std::move(magnetics), std::move(numbers))) {}

std::vector<CalibrationParameter> DeclaredLumpedModel::parameters() const {
  return state_->parameters();
}

ModelSpec DeclaredLumpedModel::spec_at(std::span<const double> values) const {
  return state_->spec_at(values);
}

LumpedModel DeclaredLumpedModel::model_at(std::span<const double> values) const {
  return state_->model_at(values);
}

}  // namespace coilwright::measurement::replay

#include "coilwright/measurement/replay/calibration_target.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace coilwright::measurement::replay {
namespace {

using actuator::LumpedModel;
using actuator::PairDimensions;

struct PlaceOfNumber {
  LumpedModel& model;

  double& operator()(const EffectNumber& number) const { return model.effects[number.effect].values[number.parameter]; }
  double& operator()(const GravityNumber& /*number*/) const { return model.gravity; }
  double& operator()(const PartNumber<mechanics::Link>& number) const {
    return model.links[number.index].*number.member;
  }
  double& operator()(const PartNumber<actuator::Hinge>& number) const {
    return model.hinges[number.index].*number.member;
  }
  double& operator()(const PartNumber<mechanics::FaceContact>& number) const {
    return model.hinges[number.index].contact.*number.member;
  }
  double& operator()(const PartNumber<magnetics::ThickCoil::Spec>& number) const {
    return dimensions(number.index).coil.*number.member;
  }
  double& operator()(const PartNumber<magnetics::CylinderMagnet::Spec>& number) const {
    return dimensions(number.index).magnet.*number.member;
  }
  double& operator()(const PartNumber<magnetics::HingeGeometry>& number) const {
    return dimensions(number.index).geometry.*number.member;
  }
  double& operator()(const TableNumber& number) const {
    return (std::get<actuator::TorqueTable>(model.pairs[number.pair].source).*number.column)[number.row];
  }

 private:
  [[nodiscard]] PairDimensions& dimensions(std::size_t pair) const {
    return std::get<PairDimensions>(model.pairs[pair].source);
  }
};

}  // namespace

void set_number(actuator::AsBuilt& differences, const ForceCurveNumber& number, double value) {
  differences.force_curve->coefficients[number.order] = value;
}

void set_number(actuator::AsBuilt& differences, const AsBuiltNumber& number, double value) {
  differences.*number.member = value - number.from;
}

void require_values(std::span<const double> values, std::size_t numbers) {
  if (values.size() != numbers)
    throw std::invalid_argument(fmt::format("calibration must have {} values; got {}", numbers, values.size()));
}

double& number_in(LumpedModel& model, const LumpedNumber& number) {
  return std::visit(PlaceOfNumber{model}, number);
}

}  // namespace coilwright::measurement::replay

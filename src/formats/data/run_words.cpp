#include "formats/data/run_words.hpp"

#include <algorithm>
#include <utility>

#include "formats/simulation/plausible_ranges.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::CoilWiring;
using measurement::data::Drive;
using measurement::data::InputHold;
using measurement::data::RunKind;
using measurement::data::Start;

// Far beyond any laboratory, and near enough that nothing overflows.
constexpr Rule turn_rule = Rule::between(-360.0, 360.0);  // deg
constexpr Rule mass_rule = Rule::between(0.0, 1e6);       // g

template <class... Values>
auto read_name(const Node& node, Values... values) {
  return node.choice({std::pair(name_of(values), values)...});
}

}  // namespace

RunKind read_run_kind(const Node& node) {
  return read_name(node, RunKind::transient, RunKind::static_torque, RunKind::joint_stiffness, RunKind::blocked_force,
                   RunKind::temperature, RunKind::still);
}

Drive read_drive(const Node& node) {
  return read_name(node, Drive::current, Drive::voltage, Drive::torque);
}

Start read_start(const Node& node) {
  return read_name(node, Start::at_rest, Start::measured, Start::free);
}

InputHold read_input_hold(const Node& node) {
  return read_name(node, InputHold::zero_order, InputHold::linear, InputHold::unknown_within_sample);
}

bool read_is_validate(ObjectReader& in, bool still) {
  const auto role = still ? in.find("role") : std::optional(in.at("role"));
  const bool validate = role && role->choice<bool>({{"fit", false}, {"validate", true}});
  if (still && validate) throw role->error("must be \"fit\": every run uses a still run, and none is held out");
  return validate;
}

measurement::data::RigChange read_rig(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    measurement::data::RigChange rig{.base_turn = in.quantity_or("base_turn_deg", 0.0, turn_rule),
                                     .tip_mass = in.quantity_or("tip_mass_g", 0.0, mass_rule)};
    if (const auto coil = in.find("coil"))
      rig.coil = read_name(*coil, CoilWiring::driven, CoilWiring::open, CoilWiring::shorted);
    return rig;
  });
}

Json rig_json(const measurement::data::RigChange& rig) {
  Json out = Json::object();
  if (rig.base_turn != 0.0) out.set(Json::quantity("base_turn_deg", rig.base_turn));
  if (rig.tip_mass != 0.0) out.set(Json::quantity("tip_mass_g", rig.tip_mass));
  if (rig.coil != CoilWiring::driven) out.set("coil", name_of(rig.coil));
  return out;
}

measurement::data::InputUncertainty read_input_uncertainty(ObjectReader& in,
                                                           const measurement::data::InputUncertainty& usual) {
  measurement::data::InputUncertainty out = usual;
  const auto sigma = in.find_not_null("input_sigma");
  if (sigma && sigma->kind() == Node::Kind::number)
    out.sigma = {sigma->number(sigma_rule)};
  else if (sigma)
    out.sigma = sigma->numbers(Length::at_least(1), sigma_rule);
  if (const auto correlation = in.find_not_null("input_correlation_s")) {
    if (out.sigma.empty())
      throw correlation->error_without_value("must not be there without input_sigma, of whose errors it is the time");
    out.correlation = correlation->quantity(time_rule);
  }
  return out;
}

void add_input_uncertainty(Json& out, const measurement::data::InputUncertainty& uncertainty) {
  if (uncertainty.sigma.empty()) return;
  const bool alike = std::ranges::all_of(uncertainty.sigma, [&](double each) { return each == uncertainty.sigma[0]; });
  if (alike)
    out.set("input_sigma", uncertainty.sigma[0]);
  else
    out.set("input_sigma", Json::numbers(uncertainty.sigma));
  if (uncertainty.correlation > 0.0) out.set("input_correlation_s", uncertainty.correlation);
}

}  // namespace coilwright::formats

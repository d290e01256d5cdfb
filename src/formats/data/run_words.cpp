#include "formats/data/run_words.hpp"

#include <utility>

#include "coilwright/text/json/object_reader.hpp"

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

CoilWiring read_coil_wiring(const Node& node) {
  return read_name(node, CoilWiring::driven, CoilWiring::open, CoilWiring::shorted);
}

measurement::data::RigChange read_rig(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    measurement::data::RigChange rig{.base_turn = in.quantity_or("base_turn_deg", 0.0, turn_rule),
                                     .tip_mass = in.quantity_or("tip_mass_g", 0.0, mass_rule)};
    if (const auto coil = in.find("coil")) rig.coil = read_coil_wiring(*coil);
    return rig;
  });
}

}  // namespace coilwright::formats

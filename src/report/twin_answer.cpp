#include "coilwright/report/twin_answer.hpp"

#include <array>
#include <utility>

#include "coilwright/report/actuator_json.hpp"
#include "report/measured_unit.hpp"

namespace coilwright::report {
namespace {

using namespace measurement;

Json instruments_json(const Instruments& instruments, double Instrument::*what) {
  constexpr std::array quantities = {std::pair("angle", Quantity::bending_angle),
                                     std::pair("rate", Quantity::joint_rate), std::pair("torque", Quantity::torque),
                                     std::pair("force", Quantity::force),
                                     std::pair("temperature", Quantity::temperature)};
  Json out = Json::object();
  for (const auto& [name, quantity] : quantities) {
    const formats::Unit unit = error_unit(quantity);
    out.set(with_unit(name, unit), formats::from_si(instruments.of(quantity).*what, unit));
  }
  return out;
}

}  // namespace

Json to_json(const TwinAnswer& answer) {
  return Json::object({{"format", "twin-answer/1"},
                       {"dataset", answer.dataset},
                       {"actuator", answer.actuator},
                       {"experiment", answer.experiment},
                       {"effects", to_json(answer.effects)},
                       {"noise", instruments_json(answer.instruments, &Instrument::noise)},
                       {"resolution", instruments_json(answer.instruments, &Instrument::resolution)},
                       {"seed", answer.seed}});
}

}  // namespace coilwright::report

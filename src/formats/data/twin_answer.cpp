#include "coilwright/formats/data/twin_answer.hpp"

#include <array>
#include <utility>

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/data/diagnosis_formatting.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement;

Json instruments_json(const experiment::Instruments& instruments, double experiment::Instrument::*what) {
  constexpr std::array quantities = {
      std::pair("angle", data::ChannelKind::bending_angle), std::pair("rate", data::ChannelKind::joint_rate),
      std::pair("torque", data::ChannelKind::torque), std::pair("force", data::ChannelKind::force),
      std::pair("temperature", data::ChannelKind::temperature)};
  Json out = Json::object();
  for (const auto& [name, quantity] : quantities) {
    const units::Unit unit = error_unit(quantity);
    out.set(with_unit(name, unit), units::from_si(instruments.of(quantity).*what, unit));
  }
  return out;
}

}  // namespace

Json to_json(const TwinAnswer& answer) {
  return Json::object(
      {{"format", "twin-answer/1"},
       {"dataset", answer.dataset},
       {"actuator", answer.actuator},
       {"experiment", answer.experiment},
       {"effects", to_json(answer.effects)},
       {"noise", instruments_json(answer.instruments, &experiment::Instrument::noise)},
       {"resolution", instruments_json(answer.instruments, &experiment::Instrument::resolution)},
       {"clocks",
        Json::list(
            answer.clocks,
            [](const ClockOfRun& each) {
              return Json::object({{"file", each.run}, {"shift_s", each.clock.shift}, {"rate", each.clock.rate}});
            })},
       {"seed", answer.seed}});
}

}  // namespace coilwright::formats

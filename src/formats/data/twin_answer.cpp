#include "coilwright/formats/data/twin_answer.hpp"

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "formats/data/experiment_parts.hpp"

namespace coilwright::formats {
using measurement::planning::Instrument;
using text::Json;

Json to_json(const TwinAnswer& answer) {
  return Json::object(
      {{"format", "twin-answer/1"},
       {"dataset", answer.dataset},
       {"actuator", answer.actuator},
       {"experiment", answer.experiment},
       {"effects", to_json(answer.effects)},
       {"noise", instruments_json(answer.instruments, &Instrument::noise)},
       {"resolution", instruments_json(answer.instruments, &Instrument::resolution)},
       {"clocks",
        Json::list(
            answer.clocks,
            [](const ClockOfRun& each) {
              return Json::object({{"file", each.run}, {"shift_s", each.clock.shift}, {"rate", each.clock.rate}});
            })},
       {"seed", answer.seed}});
}

}  // namespace coilwright::formats

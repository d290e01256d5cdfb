#include "coilwright/measurement/planning/instrument.hpp"

namespace coilwright::measurement::planning {

const Instrument& Instruments::of(data::ChannelKind kind) const {
  switch (kind) {
    case data::ChannelKind::bending_angle:
    case data::ChannelKind::joint_angle:
      return angle;
    case data::ChannelKind::joint_rate:
      return rate;
    case data::ChannelKind::torque:
      return torque;
    case data::ChannelKind::force:
      return force;
    case data::ChannelKind::temperature:
      break;
  }
  return temperature;
}

}  // namespace coilwright::measurement::planning

#include "coilwright/systems/validation/paper_finger.hpp"

namespace coilwright::systems::validation {

// The defaults of a Design are the prototype's sizes; they are repeated here so that a changed default shows.
actuator::Design paper_finger_geometry() {
  actuator::Design design;
  design.layout = actuator::layout_of(actuator::Configuration::B);
  design.coil = {.inner_radius = 3 / 1e3, .turns_radial = 15, .turns_axial = 30, .wire_gauge = 28};
  design.magnet.radius = 10 / 1e3;
  design.magnet.length = 6 / 1e3;
  design.magnet.remanence = 1.44;
  design.body.gap = 0.9 / 1e3;
  design.body.bottom_layer = 2.5 / 1e3;
  design.body.front_length = 8.6 / 1e3;
  design.body.rear_length = 20 / 1e3;
  design.surroundings.gravity = 9.81;
  design.choices = {.winding = magnetics::CurrentDistribution::paper_shells,
                    .torque = magnetics::Fidelity::line_of_centres,
                    .faces = actuator::ContactChoice::hard_parts,
                    .masses = actuator::SegmentMass::on_axis_points,
                    .ampacity = actuator::AmpacityChoice::table};
  return design;
}

actuator::Measured paper_finger_measured() {
  return {.coil_outer_radius = 9.5 / 1e3,
          .coil_length = 12 / 1e3,
          .joint_stiffness = 12.5 / 1e3,
          .joint_damping = 0.129 / 1e3,
          .axis_offset = 11.5 / 1e3,
          .magnet_segment_mass = 16.5 / 1e3,
          .tip_segment_mass = 22.5 / 1e3,
          .tip_com = 9.1 / 1e3,
          .coil_resistance = {},
          .continuous_current = 1.1};
}

actuator::Design paper_finger() {
  actuator::Design design = paper_finger_geometry();
  design.calibration = actuator::calibrate(design, paper_finger_measured());
  return design;
}

}  // namespace coilwright::systems::validation

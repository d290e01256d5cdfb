#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/mechanics/silicone_grade.hpp"
#include "error_text.hpp"

namespace coilwright::actuator {

/// The prototype's geometry (Table I of the source paper) under the paper's own conventions, nothing measured yet.
inline Design paper_geometry() {
  Design design;
  design.choices = {.winding = magnetics::CurrentDistribution::paper_shells,
                    .torque = magnetics::Fidelity::line_of_centres,
                    .faces = ContactChoice::hard_parts,
                    .masses = SegmentMass::on_axis_points,
                    .ampacity = AmpacityChoice::table};
  return design;
}

/// Table II of the paper, and its continuous current.
inline Measured paper_measured() {
  return {.coil_outer_radius = {},
          .coil_length = {},
          .joint_stiffness = 12.5e-3,
          .joint_damping = 1.29e-4,
          .axis_offset = 11.5e-3,
          .magnet_segment_mass = 16.5e-3,
          .tip_segment_mass = 22.5e-3,
          .tip_com = 9.1e-3,
          .coil_resistance = {},
          .continuous_current = 1.1};
}

/// The prototype with Table II as its calibration.
inline Design paper_finger() {
  Design design = paper_geometry();
  design.calibration = calibrate(design, paper_measured());
  return design;
}

/// Makes magnets of a grade that keep their remanence, density and temperature limit.
inline void make_of_grade(MagnetDesign& magnet, std::string_view name) {
  const MagnetDesign before = magnet;
  magnet.make_of(magnetics::find_magnet_grade(name));
  magnet.remanence = before.remanence;
  magnet.density = before.density;
  magnet.temperature_limit = before.temperature_limit;
}

/// A finger of the default parts of that silicone, of which nothing was measured.
inline Design of_silicone(std::string_view name, double bottom_layer) {
  Design design;
  design.body.make_of(&*std::ranges::find(mechanics::silicone_grades(), name, &mechanics::SiliconeGrade::name));
  design.body.bottom_layer = bottom_layer;
  return design;
}

}  // namespace coilwright::actuator

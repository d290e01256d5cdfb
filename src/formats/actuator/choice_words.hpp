#pragma once

#include <array>
#include <string_view>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/drive/coil_bank.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/text/row.hpp"

namespace coilwright::formats {

/// What files call the values of a choice, in their order.
template <std::size_t Count>
using Words = std::array<std::string_view, Count>;

inline constexpr Words<3> winding_words{"paper_shells", "layer_centres", "uniform"};
inline constexpr Words<2> fidelity_words{"line_of_centres", "exact"};
inline constexpr Words<2> face_words{"hard_parts", "walls"};
inline constexpr Words<2> mass_words{"on_axis_points", "rigid_bodies"};
inline constexpr Words<3> hinge_words{"slit", "slot", "beam"};
inline constexpr Words<2> damping_words{"loss_factor", "proportional"};
inline constexpr Words<2> ampacity_words{"law", "table"};
inline constexpr Words<2> film_words{"calibrated", "still_air"};
static_assert(static_cast<int>(actuator::Wiring::series) == static_cast<int>(drive::BankWiring::series));
inline constexpr Words<3> cases_words{"both", "free", "gripping"};

/// Where the current of a pair's coil flows.
inline constexpr auto winding_row = text::choice_row<&magnetics::ThickCoil::Spec::winding>(
    "winding", winding_words, "Where in a coil the current flows");

/// Every choice of a design's model.
inline constexpr std::array model_rows = [] {
  using Choices = actuator::ModelChoices;
  using text::choice_row;
  return std::array{
      choice_row<&Choices::winding>("winding", winding_words, winding_row.meaning),
      choice_row<&Choices::torque>("torque", fidelity_words, "Torque of a joint: the paper's approximation, or exact"),
      choice_row<&Choices::faces>(
          "face_contact", face_words,
          "What stops a closing joint: the silicone from angle 0, or coil and magnet as if it were not there"),
      choice_row<&Choices::masses>("segment_mass", mass_words,
                                   "How segments carry their mass: as in the paper, or as bodies"),
      choice_row<&Choices::hinge>("hinge", hinge_words,
                                  "How stiff a hinge is: a cut without width, a cut of slot_width_mm, a strip of "
                                  "hinge_length_mm. Absent beside \"calibration\" it is beam: a file of version 0.1"),
      choice_row<&Choices::damping>("damping", damping_words,
                                    "How the silicone's part of the damping follows the hinge; the rest is constant"),
      choice_row<&Choices::ampacity>(
          "ampacity", ampacity_words,
          "Chassis-wiring current of a gauge: a smooth law through the table, or the table itself"),
      choice_row<&Choices::film>("film", film_words,
                                 "What carries heat away: the calibrated heat transfer, or still air with radiation"),
  };
}();

/// A current in every coil, A, as files and the command line take it: nothing computed from it overflows.
inline constexpr text::Rule current_rule = text::Rule::between(-1e6, 1e6);

/// The numbers of an operating point, its current first.
inline constexpr std::array operating_rows = [] {
  using Point = actuator::OperatingPoint;
  using actuator::GraspPoint;
  using actuator::Supply;
  using text::row;
  using text::Rule;
  return std::array{
      row<&Point::current>("current_A", current_rule, "In every coil; positive opens", text::Need::required),
      row<&Point::duty>("duty", Rule::between(0, 1), "Fraction of the time that the current is on; for heat alone"),
      row<&Point::period>("period_s", text::positive, "Of the duty cycle; for the ripple of temperature alone"),
      text::choice_row<&Point::cases>("cases", cases_words,
                                      "In which poses it is held, for heat: moving free, gripping a wall, or both, of "
                                      "which the worse counts"),
      text::choice_row<&Point::supply, &Supply::wiring>("wiring", drive::bank_wiring_words,
                                                        "How the coils hang on the supply"),
      row<&Point::supply, &Supply::resistance>("supply_resistance_Ohm", text::non_negative,
                                               "Inside the battery or supply, with its leads"),
      row<&Point::supply, &Supply::voltage>("supply_voltage_V", text::positive,
                                            "Of the supply without load; a current that needs more is told"),
      row<&Point::grasp, &GraspPoint::opening>(
          "grasp_opening_deg", Rule::between(0, 360),
          "Where grasp forces are taken: the bending angle at which the free finger would touch the wall"),
      row<&Point::grasp, &GraspPoint::height>("grasp_height_mm", Rule::between(0, 1e6),
                                              "Of the contact along the last segment, from its joint; absent: the tip"),
  };
}();

}  // namespace coilwright::formats

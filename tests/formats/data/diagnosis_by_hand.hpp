#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "coilwright/formats/data/diagnosis_json.hpp"
#include "degree.hpp"
#include "formats/data/named_effect.hpp"

namespace coilwright::testing {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline const NamedEffect dry_friction("dry_friction", "Coulomb friction at the hinges");
inline const NamedEffect coil_heating("coil_heating", "the coil's resistance rises");
inline const NamedEffect magnet_heating("magnet_heating", "the remanence falls");
inline constexpr std::array sides = {-1.0, 1.0};
inline const NamedEffect end_stop("end_stop", "a stop",
                                  {{.key = "angle_deg", .text = "where"},
                                   {.key = "side", .text = "which", .choices = sides}});

inline measurement::Errors degrees(double mae, double rmse, double max) {
  return {.mae = mae * degree, .rmse = rmse * degree, .max = max * degree};
}

inline measurement::ErrorComparison comparison(measurement::data::ChannelKind kind, std::size_t samples,
                                               double noise_floor) {
  return {.kind = kind, .samples = samples, .declared = {}, .before = {}, .after = {}, .noise_floor_rmse = noise_floor};
}

// Stiff at 40 degrees, on the lower side.
inline measurement::AddedEffect stopped() {
  return {.kind = &end_stop,
          .parameters = {{.key = "angle_deg", .value = 40.0 * degree, .lower = 39.0 * degree, .upper = 41.0 * degree},
                         {.key = "side", .value = -1.0, .lower = -1.0, .upper = -1.0, .chosen = true}}};
}

// A hypothesis that was compared. Its evidence is that of its chi-square alone, over 52,000 without effects.
inline measurement::identification::WeighedHypothesis weighed(std::vector<const actuator::EffectKind*> effects,
                                                              double chi_square, double probability,
                                                              double probability_of_noise = 0.0) {
  return {.effects = std::move(effects),
          .chi_square = chi_square,
          .log_evidence = 0.5 * (52000.0 - chi_square),
          .probability = probability,
          .lacks = 0.0625,
          .lacks_over = 8.0,
          .probability_of_noise = probability_of_noise};
}

// The example of measured-data/1, as values in memory.
inline measurement::Diagnosis example() {
  measurement::Diagnosis diagnosis;
  diagnosis.verdict = measurement::Verdict::explained;
  diagnosis.effects = {{.kind = &dry_friction,
                        .parameters = {{.key = "torque_Nmm", .value = 0.61e-3, .lower = 0.58e-3, .upper = 0.64e-3}}}};
  diagnosis.odds.hypotheses = {weighed({&dry_friction}, 12000.0, 0.9375, 0.875), weighed({&end_stop}, 13000.0, 0.0625),
                               weighed({}, 52000.0, 0.0)};
  diagnosis.indistinguishable = {{&coil_heating, &magnet_heating}};
  diagnosis.validate_errors = {{.kind = measurement::data::ChannelKind::bending_angle,
                                .samples = 900,
                                .declared = degrees(2.9, 3.5, 9.1),
                                .before = degrees(1.1, 1.4, 5.0),
                                .after = degrees(0.24, 0.30, 1.2),
                                .noise_floor_rmse = 0.30 * degree}};
  diagnosis.calibration = {{.key = "joint_stiffness_Nmm_rad", .value = 12.4e-3, .lower = 12.3e-3, .upper = 12.5e-3}};
  diagnosis.after = {.level = 1.01, .structure = 0.8, .where = "step_1.4A.csv, 20 ms"};
  return diagnosis;
}

inline formats::DiagnosisReport report_of(const measurement::Diagnosis& diagnosis) {
  return {.diagnosis = diagnosis,
          .dataset = "finger-2024-03-11",
          .updated_actuator = "actuator.json",
          .held_out = {},
          .seed = 7};
}

// The same with structure left, of which a table over angle and rate takes away the most.
inline measurement::Diagnosis corrected_example() {
  measurement::Diagnosis diagnosis = example();
  diagnosis.verdict = measurement::Verdict::partly_explained;
  diagnosis.validate_errors.front().corrected = degrees(0.2, 0.25, 1.0);
  using enum actuator::CorrectionVariable;
  diagnosis.correction.found = {
      .torque = {.axes = {{.variable = angle, .nodes = {-5.0 * degree, 10.0 * degree, 40.0 * degree}},
                          {.variable = rate, .nodes = {-90.0 * degree, 0.0, 90.0 * degree}}},
                 .torques = std::vector<double>(9, 1e-4)},
      .rms = 0.5e-3,
      .explained = 0.8,
      .cross_validated_gain = 0.71,
      .degrees_of_freedom = 6.5,
      .products = {0.97, 0.99, 1.0},
      .largest = {.at = {40.0 * degree, -90.0 * degree}, .torque = 0.3e-3},
      .smallest = {.at = {40.0 * degree, 90.0 * degree}, .torque = -0.25e-3}};
  return diagnosis;
}

}  // namespace coilwright::testing

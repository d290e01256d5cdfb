#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/measurement/design_posterior.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The results of `diagnose` that are to be written.
struct DiagnosisReport {
  const measurement::Diagnosis& diagnosis;  ///< must outlive the report
  std::string dataset{};                    ///< name of the data set
  std::string updated_actuator{};           ///< file of the updated actuator, beside the report
  bool is_design{};                         ///< it is a design, which studies vary; otherwise a lumped model
  std::string corrected_actuator{};         ///< file with a nameless correction; empty if there is none
  std::vector<std::string> held_out{};      ///< files that the tool itself kept from the fit
  std::uint64_t seed{};
  std::string next_experiment_file{};  ///< file of the next experiment, beside the report; empty: it is not written
  /// Reasons why the actuator files are refused as input, a line each: a fit may find numbers that no actuator can
  /// have. Empty: they are accepted.
  std::vector<std::string> refused{};
  std::optional<measurement::DesignPosterior> posterior{};  ///< of a design's numbers; absent for a lumped model
  text::Json summary{};                                     ///< what the rest says in words
};

/// diagnosis.json, format `diagnosis/1`: the keys of the format first, in its order, then those that go beyond it
/// (docs/formats-diagnosis.md). Numbers that do not exist (an open end of an interval, a criterion without a value) are
/// null. It has no timings, so the same diagnosis gives the same bytes.
[[nodiscard]] text::Json to_json(const DiagnosisReport& report);

}  // namespace coilwright::formats

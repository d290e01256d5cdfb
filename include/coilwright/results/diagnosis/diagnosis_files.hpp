#pragma once

#include <array>
#include <string>

#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/results/diagnosis/asked_diagnosis.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::results {

/// Every file that a diagnosis may write into its folder.
inline constexpr std::array diagnosis_files = {"diagnosis.json",      "actuator.json", "corrected_actuator.json",
                                               "residuals.csv",       "summary.txt",   "next_experiment.json",
                                               "next_experiment.csv", provenance_name};

/// The answer of a diagnosis as texts.
struct DiagnosisAnswer {
  std::string summary{};             ///< the text of summary.txt
  std::string json{};                ///< diagnosis.json
  std::string actuator{};            ///< the corrected actuator's file
  std::string corrected_actuator{};  ///< the actuator with the nameless correction; empty if there is none
  std::string next_experiment{};     ///< an experiment/1; empty if none is proposed
};

/// The texts of a diagnosis, or of the results so far of one that was interrupted. The actuators are read back first.
[[nodiscard]] DiagnosisAnswer answer_of(const measurement::Diagnosis& diagnosis, const AskedDiagnosis& asked);

/// Writes these texts into a folder and commits it, all files or none. Files of an earlier diagnosis that this one
/// lacks are removed. Throws text::OutputError.
void write_diagnosis(const measurement::Diagnosis& diagnosis, const AskedDiagnosis& asked,
                     const DiagnosisAnswer& answer, text::OutputFolder& folder);

}  // namespace coilwright::results

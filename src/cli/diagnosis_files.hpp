#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "provenance.hpp"

namespace coilwright::cli {

/// Every file that a diagnosis may write into its folder.
inline constexpr std::array diagnosis_files = {"diagnosis.json",      "actuator.json", "corrected_actuator.json",
                                               "residuals.csv",       "summary.txt",   "next_experiment.json",
                                               "next_experiment.csv", provenance_name};

/// The answer of a diagnosis as texts.
struct DiagnosisTexts {
  std::string summary;
  std::string json;
};

/// Writes a diagnosis, or what is known of one that was interrupted, all files or none: the corrected actuator is read
/// back first. Files of an earlier diagnosis that this one has none of are removed. Before anything is written, `print`
/// is given the answer, so that no disk can lose it. Throws OutputError.
void write_diagnosis(const measurement::Diagnosis& diagnosis, const formats::DatasetFile& set,
                     const formats::DeclaredActuator& declared, const Provenance& provenance, const std::string& folder,
                     const std::function<void(const DiagnosisTexts&)>& print);

}  // namespace coilwright::cli

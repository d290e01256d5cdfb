#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/results/provenance.hpp"

namespace coilwright::results {

/// A data set and its declarations, read and checked before the work.
struct AskedDiagnosis {
  formats::DatasetFile set;
  std::filesystem::path declared_file;
  formats::DeclaredActuator declared;
  Provenance provenance;
  actuator::EffectCatalogue effects;  ///< effects that the model has or may lack
};

/// Reads a data set and the actuator that it names, or the file `actuator` instead. Throws text::InputError.
[[nodiscard]] AskedDiagnosis read_asked(const std::filesystem::path& dataset,
                                        const std::optional<std::filesystem::path>& actuator, std::uint64_t seed,
                                        const actuator::EffectCatalogue& effects = actuator::standard_effects());

/// Diagnoses it with its effects and beliefs. A set that does not fit its model, or a model that cannot be simulated,
/// counts as bad data: throws text::InputError of the file at fault.
[[nodiscard]] measurement::Diagnosis diagnose(const AskedDiagnosis& asked, measurement::DiagnosisOptions how);

/// Refuses its records, fitted or not, that were written under another convention than they say, as diagnose() does
/// (measurement::require_no_slip). Throws text::InputError likewise.
void require_no_slip(const AskedDiagnosis& asked);

}  // namespace coilwright::results

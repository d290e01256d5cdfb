#include "coilwright/results/diagnosis/diagnosis_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/data/diagnosis_tables.hpp"
#include "coilwright/formats/data/experiment_file.hpp"
#include "coilwright/measurement/corrected_model.hpp"
#include "coilwright/report/diagnosis/diagnosis_text.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::results {
namespace {

using actuator::Effect;
using measurement::Diagnosis;

constexpr const char* diagnosis_name = diagnosis_files[0];
constexpr const char* actuator_name = diagnosis_files[1];
constexpr const char* corrected_name = diagnosis_files[2];
constexpr const char* residuals_name = diagnosis_files[3];
constexpr const char* summary_name = diagnosis_files[4];
constexpr const char* next_name = diagnosis_files[5];
constexpr const char* expected_name = diagnosis_files[6];

const std::vector<Effect>& effects_of(const formats::ActuatorFile& file) {
  if (const auto* design = std::get_if<actuator::Design>(&file.content)) return design->effects;
  return std::get<actuator::Model>(file.content).nominal_spec().effects;
}

// The files of actuators that were found, read back where they will be used.
struct FoundActuators {
  std::string updated;
  bool is_design{};
  std::string corrected;             // with the nameless correction; empty: none
  std::vector<std::string> refused;  // why a file is no input of other commands, a line each
};

// Whether every effect is there in an actuator that is read back.
void check_effects(const formats::ActuatorFile& back, const std::vector<Effect>& added) {
  const std::vector<Effect>& read = effects_of(back);
  for (const Effect& effect : added)
    if (std::ranges::find(read, effect.kind, &Effect::kind) == read.end())
      throw std::logic_error(fmt::format("{} is lost when the actuator is read back", effect.kind->id()));
}

FoundActuators found_actuators(const Diagnosis& diagnosis, const AskedDiagnosis& asked) {
  const formats::DeclaredActuator& declared = asked.declared;
  FoundActuators out;
  // A fit may go beyond what an actuator can be: its result is kept and says so, rather than being lost at the end.
  const auto read_back = [&](const std::string& text, const char* name, const std::vector<Effect>& added) {
    try {
      check_effects(formats::parse_actuator(text, name, asked.effects), added);
    } catch (const text::InputError& refusal) {
      out.refused.emplace_back(refusal.what());
    }
  };
  const std::vector<Effect> added = measurement::effects_of(diagnosis);
  const formats::UpdatedActuator updated = declared.updated(measurement::calibration_of(diagnosis), added);
  out.updated = formats::to_json(updated, declared.name).text();
  out.is_design = std::holds_alternative<actuator::Design>(updated);
  read_back(out.updated, actuator_name, added);
  if (const auto& found = diagnosis.correction.found) {
    formats::UpdatedActuator actuator = declared.updated(found->calibration, found->effects);
    std::visit([&](auto& content) { content.as_built.torque_correction = found->torque; }, actuator);
    out.corrected = formats::to_json(actuator, declared.name).text();
    read_back(out.corrected, corrected_name, found->effects);
  }
  return out;
}

// What is to be recorded next, checked where it will be used: its text is read back.
std::string next_experiment_text(const Diagnosis& diagnosis) {
  if (!diagnosis.next_experiment) return {};
  const measurement::planning::NextExperiment& next = *diagnosis.next_experiment;
  const std::string description =
      fmt::format("Proposed by a diagnosis. The last runs are to be recorded: {}: {}.", next.input, next.why);
  std::string text = formats::experiment_json(next.experiment, description).text();
  (void)formats::parse_experiment(text, next_name);
  return text;
}

}  // namespace

DiagnosisAnswer answer_of(const Diagnosis& diagnosis, const AskedDiagnosis& asked) {
  const formats::DeclaredActuator& declared = asked.declared;
  FoundActuators actuators = found_actuators(diagnosis, asked);
  std::string next_experiment = next_experiment_text(diagnosis);
  formats::DiagnosisReport report{.diagnosis = diagnosis,
                                  .dataset = asked.set.data.name,
                                  .updated_actuator = actuator_name,
                                  .is_design = actuators.is_design,
                                  .corrected_actuator = actuators.corrected.empty() ? "" : corrected_name,
                                  .held_out = asked.set.data.held_out,
                                  .seed = asked.provenance.seed.value_or(0),
                                  .next_experiment_file = next_experiment.empty() ? "" : next_name,
                                  .refused = actuators.refused};
  if (actuators.is_design)
    report.posterior = measurement::design_posterior(
        diagnosis, [&](std::span<const double> calibration, const std::vector<Effect>& added) {
          return std::get<actuator::Design>(declared.updated(calibration, added));
        });
  const report::Document document = report::document_of(report);
  report.summary = report::to_json(document);
  return {.summary = report::to_text(document),
          .json = formats::to_json(report).text(),
          .actuator = std::move(actuators.updated),
          .corrected_actuator = std::move(actuators.corrected),
          .next_experiment = std::move(next_experiment)};
}

void write_diagnosis(const Diagnosis& diagnosis, const AskedDiagnosis& asked, const DiagnosisAnswer& answer,
                     text::OutputFolder& folder) {
  const auto write_or_remove = [&](const char* name, const std::string& text) {
    if (text.empty())
      folder.remove(name);  // one of an earlier diagnosis must not stand beside this one
    else
      folder.write(name, text);
  };
  folder.write(diagnosis_name, answer.json);
  folder.write(actuator_name, answer.actuator);
  write_or_remove(corrected_name, answer.corrected_actuator);
  if (diagnosis.verdict == measurement::Verdict::incomplete)
    folder.remove(residuals_name);
  else
    formats::write_residuals(folder.open(residuals_name), diagnosis.replays);
  folder.write(summary_name, answer.summary);
  write_or_remove(next_name, answer.next_experiment);
  // Where an explanation cannot be simulated in the proposed run, there is nothing to compare.
  if (diagnosis.next_experiment && !diagnosis.next_experiment->expected.empty())
    formats::write_expected_readings(folder.open(expected_name), *diagnosis.next_experiment);
  else
    folder.remove(expected_name);
  write_provenance(folder, asked.provenance);
  folder.commit(diagnosis_name);
}

}  // namespace coilwright::results

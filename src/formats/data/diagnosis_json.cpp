#include "coilwright/formats/data/diagnosis_json.hpp"

#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/formats/data/measured_unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json in_unit_or_null(double value, const units::Unit& unit) {
  return number_or_null(units::from_si(value, unit));
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json words_json(std::span<const std::string> words) {
  Json out = Json::array();
  for (const std::string& each : words) out.add(each);
  return out;
}

Json ids_json(std::span<const actuator::EffectKind* const> kinds) {
  return words_json(ids(kinds));
}

Json estimate_json(const compare::Estimate& estimate) {
  const EstimateInUnit shown = in_unit(estimate);
  Json interval = Json::array();
  interval.add(number_or_null(shown.lower)).add(number_or_null(shown.upper));
  Json out = Json::object({{"value", number_or_null(shown.value)}, {"ci95", std::move(interval)}});
  if (shown.declared) out.set("declared", *shown.declared);
  if (!estimate.determined) out.set("determined", false);
  if (estimate.chosen) out.set("choice", true);
  if (estimate.has_many_optima) out.set("many_optima", true);
  return out;
}

Json estimates_json(std::span<const compare::Estimate> estimates) {
  Json out = Json::object();
  for (const compare::Estimate& each : estimates) out.set(each.key, estimate_json(each));
  return out;
}

// The declared numbers that the fit moved within their tolerances.
Json nominal_json(const Diagnosis& diagnosis) {
  Json out = Json::object();
  for (const MovedNumber& each : diagnosis.nominal) {
    const MovedNumberInUnit shown = in_unit(each);
    Json number = estimate_json(each.estimate);
    number.set("declared", number_or_null(shown.declared))
        .set("tolerance", number_or_null(shown.tolerance))
        .set("tolerance_from", each.named ? "set" : "default");
    if (shown.idle_from) number.set("idle_from", *shown.idle_from);
    out.set(each.estimate.key, std::move(number));
  }
  return out;
}

// Of the shape of the torque no number is known.
Json numbers_off_json(const Diagnosis& diagnosis) {
  Json out = Json::array();
  for (const compare::NumberOff& each : diagnosis.numbers_off) {
    Json number = Json::object({{"name", each.name}, {"criterion_gain", each.gain}});
    if (each.estimate) number.set("estimate", estimate_json(*each.estimate));
    out.add(std::move(number));
  }
  return out;
}

Json hinted_json(const Diagnosis& diagnosis) {
  Json out = Json::array();
  for (const compare::HintedEffect& each : diagnosis.hinted)
    out.add(Json::object(
        {{"id", each.kind->id()}, {"criterion_gain", each.gain}, {"number", each.number}, {"wider", each.wider}}));
  return out;
}

Json outliers_json(const Diagnosis& diagnosis) {
  Json out = Json::array();
  for (const Outliers& each : diagnosis.outliers) {
    Json times = Json::array();
    for (const double time : each.times) times.add(time);
    out.add(Json::object({{"run", each.run},
                          {"role", each.validate ? "validate" : "fit"},
                          {"channel", each.channel},
                          {"samples", each.times.size()},
                          {"times_s", std::move(times)}}));
  }
  return out;
}

Json evidence_json(const compare::Evidence& evidence) {
  Json untold = Json::array();
  for (const std::string& run : evidence.untold_runs) untold.add(run);
  return Json::object({{"chi_square_before", number_or_null(evidence.chi_square_before)},
                       {"chi_square_after", number_or_null(evidence.chi_square_after)},
                       {"criterion_gain", number_or_null(evidence.quasi_bic_gain)},
                       {"cross_validated_gain", number_or_null(evidence.cross_validated_gain)},
                       {"not_cross_validated", std::move(untold)},
                       {"correlation_time_samples", number_or_null(evidence.correlation_time)}});
}

Json effects_json(const Diagnosis& diagnosis) {
  Json out = Json::array();
  for (const AddedEffect& effect : diagnosis.effects)
    out.add(Json::object({{"id", effect.kind->id()},
                          {"parameters", estimates_json(effect.parameters)},
                          {"evidence", evidence_json(effect.evidence)}}));
  return out;
}

Json indistinguishable_json(const Diagnosis& diagnosis) {
  Json out = Json::array();
  for (const auto& set : diagnosis.indistinguishable) out.add(ids_json(set));
  return out;
}

Json errors_json(const Errors& errors, const units::Unit& unit) {
  return Json::object({{with_unit("mae", unit), in_unit_or_null(errors.mae, unit)},
                       {with_unit("rmse", unit), in_unit_or_null(errors.rmse, unit)},
                       {with_unit("max", unit), in_unit_or_null(errors.max, unit)}});
}

void add_comparison(Json& out, const ErrorComparison& comparison) {
  const units::Unit unit = error_unit(comparison.kind);
  out.set("declared", errors_json(comparison.declared, unit));
  out.set("before", errors_json(comparison.before, unit));
  out.set("after", errors_json(comparison.after, unit));
  if (comparison.corrected) out.set("corrected", errors_json(*comparison.corrected, unit));
  out.set(with_unit("noise_floor_rmse", unit), in_unit_or_null(comparison.noise_floor_rmse, unit));
  out.set(with_unit("uncertainty_rmse", unit), in_unit_or_null(comparison.uncertainty_rmse, unit));
  out.set("samples", comparison.samples);
}

// The first quantity's errors stand in the block itself, as the format has them; each other one in an object of its
// own beside them.
Json comparisons_json(std::span<const ErrorComparison> comparisons) {
  Json out = Json::object();
  const auto ordered = main_first(comparisons);
  if (ordered.empty()) return out;
  add_comparison(out, *ordered.front());
  out.set("quantity", name_of(ordered.front()->kind));
  for (const ErrorComparison* each : std::span(ordered).subspan(1)) {
    Json other = Json::object();
    add_comparison(other, *each);
    out.set(std::string(name_of(each->kind)), std::move(other));
  }
  return out;
}

Json next_experiment_json(const DiagnosisReport& report) {
  if (!report.diagnosis.next_experiment) return nullptr;
  const experiment::NextExperiment& next = *report.diagnosis.next_experiment;
  return Json::object({{"kind", next.kind},
                       {"input", next.input},
                       {"why", next.why},
                       {"separation", number_or_null(next.separation)},
                       {"file", text_or_null(report.next_experiment_file)}});
}

Json place_json(const correction::NamelessCorrection& found, const correction::CorrectionPlace& place) {
  Json out = Json::object();
  for (std::size_t i = 0; i < place.at.size(); ++i) {
    const std::string_view name = name_of(found.torque.axes[i].variable);
    const units::Unit unit = variable_unit(name);
    out.set(with_unit(name, unit), in_unit_or_null(place.at[i], unit));
  }
  const units::Unit torque = error_unit(data::ChannelKind::torque);
  return std::move(out.set(with_unit("torque", torque), in_unit_or_null(place.torque, torque)));
}

// The nodes themselves are in the file of the corrected actuator.
Json correction_json(const Diagnosis& diagnosis) {
  if (!diagnosis.correction.found) return nullptr;
  const correction::NamelessCorrection& found = *diagnosis.correction.found;
  Json variables = Json::array();
  for (const actuator::CorrectionAxis& axis : found.torque.axes) {
    const units::Unit unit = variable_unit(name_of(axis.variable));
    variables.add(Json::object({{"variable", name_of(axis.variable)},
                                {with_unit("from", unit), in_unit_or_null(axis.nodes.front(), unit)},
                                {with_unit("to", unit), in_unit_or_null(axis.nodes.back(), unit)}}));
  }
  const units::Unit torque = error_unit(data::ChannelKind::torque);
  Json stay = Json::array();
  for (const actuator::Effect& effect : found.effects) stay.add(effect.kind->id());
  return Json::object({{"variables", std::move(variables)},
                       {"effects", std::move(stay)},
                       {with_unit("rms", torque), in_unit_or_null(found.rms, torque)},
                       {"explained", number_or_null(found.explained)},
                       {"cross_validated_gain", number_or_null(found.cross_validated_gain)},
                       {"degrees_of_freedom", number_or_null(found.degrees_of_freedom)},
                       {"products", Json::numbers(found.products)},
                       {"largest", place_json(found, found.largest)},
                       {"smallest", place_json(found, found.smallest)}});
}

Json candidates_json(const Diagnosis& diagnosis) {
  Json out = Json::array();
  for (const compare::ComparedHypothesis& candidate : compared_as_reported(diagnosis))
    out.add(Json::object({{"effects", ids_json(candidate.effects)},
                          {"evidence", candidate.evidence ? evidence_json(*candidate.evidence) : Json(nullptr)},
                          {"remark", text_or_null(candidate.remark)}}));
  return out;
}

Json adequacy_json(const whiteness::WhitenessResult& adequacy) {
  return Json::object({{"level", number_or_null(adequacy.level)},
                       {"structure", number_or_null(adequacy.whiteness_ratio)},
                       {"where", text_or_null(adequacy.where)},
                       {"noise_only", adequacy.is_white()}});
}

Json in_unit_json(std::span<const double> values, const units::Unit& unit) {
  Json out = Json::array();
  for (const double value : values) out.add(in_unit_or_null(value, unit));
  return out;
}

Json residual_json(const Diagnosis& diagnosis) {
  if (!diagnosis.residual) return nullptr;
  const localise::ResidualTorque& residual = *diagnosis.residual;
  const units::Unit torque = error_unit(data::ChannelKind::torque);
  Json dependences = Json::array();
  for (const localise::Dependence& each : residual.dependences) {
    const units::Unit unit = variable_unit(each.variable);
    dependences.add(Json::object({{"variable", each.variable},
                                  {"explained", number_or_null(each.explained)},
                                  {with_unit("at", unit), in_unit_json(each.at, unit)},
                                  {with_unit("residual", torque), in_unit_json(each.residual, torque)}}));
  }
  Json out = Json::object({{with_unit("rms", torque), in_unit_or_null(residual.rms, torque)},
                           {with_unit("smallest_visible", torque), in_unit_or_null(residual.noise_floor, torque)},
                           {"dependences", std::move(dependences)}});
  out.set("frequency_Hz", residual.frequency ? number_or_null(*residual.frequency) : Json(nullptr));
  return out;
}

Json noise_json(const Diagnosis& diagnosis) {
  Json out = Json::array();
  for (const noise::NoiseLevel& each : diagnosis.noise) {
    const units::Unit unit = units::difference_unit(each.channel);
    out.add(Json::object({{"run", each.run},
                          {"channel", each.channel},
                          {with_unit("sigma", unit), in_unit_or_null(each.sigma, unit)},
                          {"source", each.source},
                          {"colour", text_or_null(each.colour)}}));
  }
  return out;
}

Json warning_json(const data::Warning& warning) {
  return Json::object({{"run", text_or_null(warning.run)}, {"text", warning.text}});
}

Json warnings_json(const std::vector<data::Warning>& warnings) {
  Json out = Json::array();
  for (const data::Warning& each : warnings) out.add(warning_json(each));
  return out;
}

}  // namespace

Json to_json(const DiagnosisReport& report) {
  const Diagnosis& diagnosis = report.diagnosis;
  Json out = Json::object({{"format", "diagnosis/1"}, {"verdict", name_of(diagnosis.verdict)}});
  out.set("effects", effects_json(diagnosis)).set("indistinguishable", indistinguishable_json(diagnosis));
  out.set("error", Json::object({{"validate", comparisons_json(diagnosis.validate_errors)},
                                 {"fit", comparisons_json(diagnosis.fit_errors)}}));
  out.set("calibration", estimates_json(diagnosis.calibration));
  out.set("updated_actuator", report.updated_actuator);
  out.set("next_experiment", next_experiment_json(report));
  out.set("nominal", nominal_json(diagnosis)).set("outliers", outliers_json(diagnosis));
  out.set("corrected_actuator", text_or_null(report.corrected_actuator));
  // Beyond the format.
  out.set("refused", words_json(report.refused));
  out.set("probability_of_declared",
          diagnosis.nominal.empty() ? Json(nullptr) : number_or_null(diagnosis.probability_of_declared));
  out.set("hinted", hinted_json(diagnosis)).set("numbers_off", numbers_off_json(diagnosis));
  out.set("model_error", diagnosis.model_error);
  out.set("held_exact", words_json(diagnosis.held_exact));
  out.set("dataset", report.dataset).set("seed", report.seed).set("held_out", words_json(report.held_out));
  out.set("adequacy",
          Json::object({{"before", adequacy_json(diagnosis.before)}, {"after", adequacy_json(diagnosis.after)}}));
  out.set("nameless_correction", correction_json(diagnosis));
  out.set("no_correction", text_or_null(diagnosis.correction.reason));
  out.set("residual", residual_json(diagnosis)).set("candidates", candidates_json(diagnosis));
  out.set("noise", noise_json(diagnosis)).set("warnings", warnings_json(diagnosis.warnings));
  out.set("unanswered_runs", warnings_json(diagnosis.unanswered_runs));
  out.set("frozen_runs", words_json(diagnosis.frozen_runs));
  out.set("far_first_pose", diagnosis.far_first_pose ? warning_json(*diagnosis.far_first_pose) : Json(nullptr));
  return out;
}

}  // namespace coilwright::formats

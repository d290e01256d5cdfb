#include "coilwright/formats/data/diagnosis_json.hpp"

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/data/diagnosis_formatting.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement;

Json in_unit_or_null(double value, const units::Unit& unit) {
  return number_or_null(units::from_si(value, unit));
}

Json ids_json(std::span<const actuator::EffectKind* const> kinds) {
  return Json::list(ids(kinds));
}

Json estimate_json(const identification::Estimate& estimate) {
  const EstimateInUnit shown = in_unit(estimate);
  Json out = Json::object({{"value", number_or_null(shown.value)},
                           {"ci95", Json::array({number_or_null(shown.lower), number_or_null(shown.upper)})}});
  if (shown.declared) out.set("declared", *shown.declared);
  if (!estimate.determined) out.set("determined", false);
  if (estimate.chosen) out.set("choice", true);
  if (estimate.has_many_optima) out.set("many_optima", true);
  return out;
}

Json estimates_json(std::span<const identification::Estimate> estimates) {
  Json out = Json::object();
  for (const identification::Estimate& each : estimates) out.set(each.key, estimate_json(each));
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
Json number_off_json(const identification::NumberOff& each) {
  Json out = Json::object({{"name", each.name}, {"criterion_gain", each.gain}});
  if (each.estimate) out.set("estimate", estimate_json(*each.estimate));
  return out;
}

Json hinted_json(const identification::HintedEffect& each) {
  return Json::object(
      {{"id", each.kind->id()}, {"criterion_gain", each.gain}, {"number", each.number}, {"wider", each.wider}});
}

Json outliers_json(const Outliers& each) {
  return Json::object({{"run", each.run},
                       {"role", each.validate ? "validate" : "fit"},
                       {"channel", each.channel},
                       {"samples", each.times.size()},
                       {"times_s", Json::numbers(each.times)}});
}

Json effect_json(const Diagnosis& diagnosis, const AddedEffect& effect) {
  return Json::object({{"id", effect.kind->id()},
                       {"parameters", estimates_json(effect.parameters)},
                       {"evidence", Json::object({{"probability", probability_of(diagnosis, *effect.kind)}})}});
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
  const planning::NextExperiment& next = *report.diagnosis.next_experiment;
  return Json::object({{"kind", next.kind},
                       {"input", next.input},
                       {"why", next.why},
                       {"open_bits", next.open_bits},
                       {"remaining_bits", next.remaining_bits},
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
  Json variables = Json::list(found.torque.axes, [](const actuator::CorrectionAxis& axis) {
    const units::Unit unit = variable_unit(name_of(axis.variable));
    return Json::object({{"variable", name_of(axis.variable)},
                         {with_unit("from", unit), in_unit_or_null(axis.nodes.front(), unit)},
                         {with_unit("to", unit), in_unit_or_null(axis.nodes.back(), unit)}});
  });
  const units::Unit torque = error_unit(data::ChannelKind::torque);
  return Json::object(
      {{"variables", std::move(variables)},
       {"effects", Json::list(found.effects, [](const actuator::Effect& each) { return each.kind->id(); })},
       {with_unit("rms", torque), in_unit_or_null(found.rms, torque)},
       {"explained", number_or_null(found.explained)},
       {"cross_validated_gain", number_or_null(found.cross_validated_gain)},
       {"degrees_of_freedom", number_or_null(found.degrees_of_freedom)},
       {"products", Json::numbers(found.products)},
       {"largest", place_json(found, found.largest)},
       {"smallest", place_json(found, found.smallest)}});
}

Json candidate_json(const identification::WeighedHypothesis& each) {
  return Json::object({{"effects", ids_json(each.effects)},
                       {"probability", number_or_null(each.probability)},
                       {"log_evidence", number_or_null(each.log_evidence)},
                       {"chi_square", number_or_null(each.chi_square)},
                       {"lacks_over_noise", number_or_null(each.lacks)},
                       {"lacks_over_samples", number_or_null(each.lacks_over)},
                       {"probability_of_noise", number_or_null(each.probability_of_noise)},
                       {"at_optimum", each.at_optimum}});
}

Json ruled_out_json(const identification::RuledOut& each) {
  return Json::object({{"effects", ids_json(each.effects)}, {"remark", each.remark}});
}

// Of each effect in a hypothesis that was fitted, the most probable first; of no effect; and of what is reported, that
// what it leaves is noise.
Json odds_json(const Diagnosis& diagnosis) {
  const identification::Posterior& odds = diagnosis.odds;
  const identification::WeighedHypothesis* reported = reported_hypothesis(diagnosis);
  if (reported == nullptr) return nullptr;
  Json effects = Json::object();
  for (const auto& [id, probability] : odds.effects()) effects.set(std::string(id), probability);
  return Json::object({{"no_effect", number_or_null(odds.probability_of(std::vector<const actuator::EffectKind*>()))},
                       {"effects", std::move(effects)},
                       {"noise", number_or_null(reported->probability_of_noise)}});
}

Json adequacy_json(const signals::WhitenessResult& adequacy) {
  return Json::object({{"level", number_or_null(adequacy.level)},
                       {"structure", number_or_null(adequacy.structure)},
                       {"where", text_or_null(adequacy.where)},
                       {"noise_only", adequacy.is_white()}});
}

Json in_unit_json(std::span<const double> values, const units::Unit& unit) {
  return Json::list(values, [&](double value) { return in_unit_or_null(value, unit); });
}

Json residual_json(const Diagnosis& diagnosis) {
  if (!diagnosis.residual) return nullptr;
  const localise::ResidualTorque& residual = *diagnosis.residual;
  const units::Unit torque = error_unit(data::ChannelKind::torque);
  Json dependences = Json::list(residual.dependences, [&](const localise::Dependence& each) {
    const units::Unit unit = variable_unit(each.variable);
    return Json::object({{"variable", each.variable},
                         {"explained", number_or_null(each.explained)},
                         {with_unit("at", unit), in_unit_json(each.at, unit)},
                         {with_unit("residual", torque), in_unit_json(each.residual, torque)}});
  });
  return Json::object({{with_unit("rms", torque), in_unit_or_null(residual.rms, torque)},
                       {with_unit("smallest_visible", torque), in_unit_or_null(residual.noise_floor, torque)},
                       {"dependences", std::move(dependences)},
                       {"frequency_Hz", number_or_null(residual.frequency)}});
}

Json noise_json(const signals::NoiseLevel& each) {
  const units::Unit unit = units::difference_unit(each.channel);
  return Json::object({{"run", each.run},
                       {"channel", each.channel},
                       {with_unit("sigma", unit), in_unit_or_null(each.sigma, unit)},
                       {"source", each.source},
                       {"colour", text_or_null(each.colour)}});
}

Json warning_json(const data::Warning& warning) {
  return Json::object({{"run", text_or_null(warning.run)}, {"text", warning.text}});
}

Json posterior_json(const std::optional<DesignPosterior>& posterior) {
  if (!posterior || posterior->numbers.empty()) return nullptr;
  Json numbers = Json::object();
  for (const DesignPosterior::Number& each : posterior->numbers)
    numbers.set(each.name, Json::object({{"value", each.value}, {"sd", each.sd}}));
  std::vector<std::vector<double>> rows;
  for (const auto& row : posterior->correlation.rowwise()) rows.emplace_back(row.begin(), row.end());
  return Json::object({{"numbers", std::move(numbers)},
                       {"correlations", Json::list(rows, [](const auto& row) { return Json::numbers(row); })}});
}

}  // namespace

Json to_json(const DiagnosisReport& report) {
  const Diagnosis& diagnosis = report.diagnosis;
  Json out = Json::object({{"format", "diagnosis/1"}, {"verdict", name_of(diagnosis.verdict)}});
  out.set("effects",
          Json::list(diagnosis.effects, [&](const AddedEffect& each) { return effect_json(diagnosis, each); }))
      .set("indistinguishable", Json::list(diagnosis.indistinguishable, ids_json));
  out.set("error", Json::object({{"validate", comparisons_json(diagnosis.validate_errors)},
                                 {"fit", comparisons_json(diagnosis.fit_errors)}}));
  out.set("calibration", estimates_json(diagnosis.calibration));
  out.set("updated_actuator", report.updated_actuator);
  out.set("next_experiment", next_experiment_json(report));
  out.set("nominal", nominal_json(diagnosis)).set("outliers", Json::list(diagnosis.outliers, outliers_json));
  out.set("corrected_actuator", text_or_null(report.corrected_actuator));
  // Beyond the format.
  out.set("refused", Json::list(report.refused));
  out.set("probability_of_declared",
          diagnosis.nominal.empty() ? Json() : number_or_null(diagnosis.probability_of_declared));
  out.set("hinted", Json::list(diagnosis.hinted, hinted_json))
      .set("numbers_off", Json::list(diagnosis.numbers_off, number_off_json));
  out.set("model_error", diagnosis.model_error);
  out.set("held_exact", Json::list(diagnosis.held_exact));
  out.set("dataset", report.dataset).set("seed", report.seed).set("held_out", Json::list(report.held_out));
  out.set("adequacy",
          Json::object({{"before", adequacy_json(diagnosis.before)}, {"after", adequacy_json(diagnosis.after)}}));
  out.set("nameless_correction", correction_json(diagnosis));
  out.set("no_correction", text_or_null(diagnosis.correction.reason));
  out.set("residual", residual_json(diagnosis))
      .set("candidates", Json::list(diagnosis.odds.hypotheses, candidate_json))
      .set("ruled_out", Json::list(diagnosis.odds.ruled_out, ruled_out_json))
      .set("not_tested", Json::list(ids(diagnosis.odds.not_tested())));
  out.set("odds", odds_json(diagnosis));
  out.set("noise", Json::list(diagnosis.noise, noise_json))
      .set("warnings", Json::list(diagnosis.warnings, warning_json));
  out.set("unanswered_runs", Json::list(diagnosis.unanswered_runs, warning_json));
  out.set("frozen_runs", Json::list(diagnosis.frozen_runs));
  out.set("far_first_pose", diagnosis.far_first_pose ? warning_json(*diagnosis.far_first_pose) : Json());
  out.set("posterior", posterior_json(report.posterior));
  out.set("summary", report.summary);
  return out;
}

}  // namespace coilwright::formats

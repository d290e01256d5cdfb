#include "cli/bench/diagnosis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/formats/data/diagnosis_tables.hpp"
#include "coilwright/measurement/replay/declare.hpp"
#include "coilwright/measurement/replayed_runs.hpp"
#include "coilwright/results/diagnosis/asked_diagnosis.hpp"
#include "coilwright/results/diagnosis/diagnosis_files.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {

// By channel, SI; absent where the model cannot be simulated.
using Shown = std::optional<std::vector<std::vector<double>>>;

struct OpenedDiagnosis {
  measurement::ReplayedRuns runs;
  std::vector<std::size_t> used{};             // the runs that both models can be simulated in, as in a diagnosis
  std::vector<Shown> declared{}, corrected{};  // one per run
  std::vector<std::pair<std::size_t, std::size_t>> channels{};  // run and channel of each one of the page
};

namespace {

using measurement::Replay;
using text::Json;

constexpr std::size_t most_samples_drawn = 2000;
constexpr const char* diagnosis_name = results::diagnosis_files[0];

measurement::replay::DeclaredModel model_of(const actuator::Design& design) {
  return measurement::replay::declare(design, {});
}

// Squared errors of one model.
struct SquareSum {
  double sum{};
  std::size_t samples{};

  void add(const Replay& measured, const std::vector<double>& shown) {
    for (std::size_t i = 0; i < shown.size(); ++i) {
      if (!measured.left_out.empty() && measured.left_out[i] != 0) continue;
      const double error = measured.measured[i] - shown[i];
      sum += error * error;
      ++samples;
    }
  }
  [[nodiscard]] Json rmse(const units::Unit& unit) const {
    return text::number_or_null(units::from_si(std::sqrt(sum / static_cast<double>(samples)), unit));
  }
};

// Errors of the three models in one kind of channel. The turned design may be one that cannot be simulated.
struct ErrorsOfThree {
  measurement::data::ChannelKind kind{};
  bool validate{};
  SquareSum declared{}, corrected{}, turned{};
  bool has_turned = true;

  void add(const OpenedDiagnosis& diagnosis, std::size_t run, std::size_t channel, const Shown& shown) {
    const Replay& measured = diagnosis.runs.channels(run)[channel];
    declared.add(measured, (*diagnosis.declared[run])[channel]);
    corrected.add(measured, (*diagnosis.corrected[run])[channel]);
    if (shown) turned.add(measured, (*shown)[channel]);
    has_turned = has_turned && shown.has_value();
  }
  [[nodiscard]] Json json() const {
    const units::Unit unit = formats::error_unit(kind);
    return Json::object({{"role", validate ? "validate" : "fit"},
                         {"quantity", formats::name_of(kind)},
                         {"unit", unit.suffix},
                         {"samples", declared.samples},
                         {"declared", declared.rmse(unit)},
                         {"corrected", corrected.rmse(unit)},
                         {"turned", has_turned ? turned.rmse(unit) : Json()}});
  }
};

// Every n-th value in the unit of a name; null for those that `without` marks.
Json thinned(const std::vector<double>& values, std::size_t every, std::string_view name,
             const std::vector<char>& without = {}) {
  const units::Unit unit = units::difference_unit(name);
  Json out = Json::array();
  for (std::size_t i = 0; i < values.size(); i += every)
    out.add(!without.empty() && without[i] != 0 ? Json() : text::number_or_null(units::from_si(values[i], unit)));
  return out;
}

text::Node member_of(const text::Node& object, std::string_view key) {
  if (const auto found = object.find(key)) return *found;
  throw object.error_without_value(fmt::format("must have \"{}\", as diagnose writes it", key));
}

}  // namespace

bool has_diagnosis(const std::filesystem::path& folder) {
  std::error_code none;
  return std::filesystem::is_regular_file(folder / diagnosis_name, none);
}

std::shared_ptr<const OpenedDiagnosis> open_diagnosis(const std::filesystem::path& folder,
                                                      const actuator::Design& corrected) {
  const std::optional<results::InputsBehind> inputs = results::inputs_behind(folder);
  if (!inputs || inputs->files.size() < 2)
    throw text::InputError(
        {.file = folder.string(),
         .rule = fmt::format("cannot be opened: it has no {} that names its data set", results::provenance_name)});
  if (!inputs->changed.empty())
    throw text::InputError({.file = folder.string(),
                            .rule = fmt::format("cannot be opened: {}, which this diagnosis is of, is not there as it "
                                                "was; run diagnose again",
                                                inputs->changed)});
  const results::AskedDiagnosis asked = results::read_asked(inputs->files[0], inputs->files[1], 0);
  const text::Document document = text::read_json(folder / diagnosis_name);
  const measurement::replay::DeclaredModel found = model_of(corrected);
  measurement::ReplayedRuns::Known known{.model_error = member_of(document.root(), "model_error").number()};
  for (const text::Node& each : member_of(document.root(), "outliers").elements())
    known.outliers.push_back({.run = member_of(each, "run").text(),
                              .channel = member_of(each, "channel").text(),
                              .validate = member_of(each, "role").text() == "validate",
                              .times = member_of(each, "times_s").numbers()});
  auto out = std::make_shared<OpenedDiagnosis>(
      OpenedDiagnosis{.runs = measurement::ReplayedRuns(asked.set.data, found, known)});
  for (std::size_t run = 0; run < out->runs.size(); ++run) {
    const Shown& as_declared = out->declared.emplace_back(out->runs.shown_of(run, asked.declared.model));
    const Shown& as_corrected = out->corrected.emplace_back(out->runs.shown_of(run, found));
    if (!as_declared || !as_corrected) continue;
    out->used.push_back(run);
    for (std::size_t channel = 0; channel < out->runs.channels(run).size(); ++channel)
      out->channels.emplace_back(run, channel);
  }
  if (out->used.empty())
    throw text::InputError(
        {.file = folder.string(), .rule = "cannot be opened: none of its runs can be simulated by both of its models"});
  return out;
}

Json diagnosis_json(const std::filesystem::path& folder, const OpenedDiagnosis& diagnosis) {
  const text::Document document = text::read_json(folder / diagnosis_name);
  Json intervals = Json::object();
  for (const text::Node& effect : member_of(document.root(), "effects").elements())
    for (const text::Node& number : member_of(effect, "parameters").members())
      intervals.set(fmt::format("{}.{}", member_of(effect, "id").text(), number.key()),
                    member_of(number, "ci95").value());
  return Json::object({{"verdict", member_of(member_of(document.root(), "summary"), "verdict").text()},
                       {"intervals", std::move(intervals)},
                       {"channels", Json::list(diagnosis.channels, [&](const auto& each) {
                          const Replay& measured = diagnosis.runs.channels(each.first)[each.second];
                          return Json::object({{"run", measured.run},
                                               {"role", measured.validate ? "validate" : "fit"},
                                               {"channel", measured.channel}});
                        })}});
}

Json record_of(const Bench& bench, const Turned& turned, std::size_t number) {
  if (!bench.diagnosis || number >= bench.diagnosis->channels.size())
    throw text::InputError(
        {.file = "question", .place = "/channel", .rule = "must be that of a channel of the diagnosis"});
  const OpenedDiagnosis& diagnosis = *bench.diagnosis;
  const auto [run, channel] = diagnosis.channels[number];
  const Replay& measured = diagnosis.runs.channels(run)[channel];
  const Shown shown = diagnosis.runs.shown_of(run, model_of(turned.design));
  ErrorsOfThree errors{.kind = measured.kind, .validate = measured.validate};
  errors.add(diagnosis, run, channel, shown);
  const std::size_t every = measured.at.size() / most_samples_drawn + 1;
  const std::string_view axis = formats::axis_of(measured.kind);
  const auto series = [&](const std::vector<double>& values) { return thinned(values, every, measured.channel); };
  return Json::object({{"axis", axis},
                       {"channel", measured.channel},
                       {"every", every},
                       {"at", thinned(measured.at, every, axis)},
                       {"measured", thinned(measured.measured, every, measured.channel, measured.left_out)},
                       {"declared", series((*diagnosis.declared[run])[channel])},
                       {"corrected", series((*diagnosis.corrected[run])[channel])},
                       {"turned", shown ? series((*shown)[channel]) : Json()},
                       {"rmse", errors.json()}});
}

Json errors_of(const Bench& bench, const Turned& turned, const NewestFirst::Turn& turn) {
  std::vector<ErrorsOfThree> groups;
  if (!bench.diagnosis) return Json::array();
  const OpenedDiagnosis& diagnosis = *bench.diagnosis;
  const measurement::replay::DeclaredModel model = model_of(turned.design);
  for (const std::size_t run : diagnosis.used) {
    turn.require_wanted();
    const Shown shown = diagnosis.runs.shown_of(run, model);
    for (std::size_t channel = 0; channel < diagnosis.runs.channels(run).size(); ++channel) {
      const Replay& measured = diagnosis.runs.channels(run)[channel];
      const auto same = std::ranges::find_if(groups, [&](const ErrorsOfThree& each) {
        return each.validate == measured.validate && formats::name_of(each.kind) == formats::name_of(measured.kind);
      });
      ErrorsOfThree& group =
          same != groups.end()
              ? *same
              : groups.emplace_back(ErrorsOfThree{.kind = measured.kind, .validate = measured.validate});
      group.add(diagnosis, run, channel, shown);
    }
  }
  return Json::list(groups, &ErrorsOfThree::json);
}

}  // namespace coilwright::cli

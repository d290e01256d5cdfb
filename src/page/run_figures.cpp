#include "page/run_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <string_view>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "coilwright/page/chart.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "page/result_words.hpp"

namespace coilwright::page {
namespace {

constexpr std::array<std::string_view, 3> axes = {"time_s", "angle_deg", "current_A"};

// "angle, deg" of "bending_angle_deg" and the like: the column's own name says it.
std::string axis_title(std::string_view axis) {
  if (axis == "time_s") return "time, s";
  if (axis == "angle_deg") return "angle, deg";
  return "current, A";
}

RunRecord::Prediction& prediction_of(RunRecord& record, std::string_view name) {
  const auto found = std::ranges::find(record.predictions, name, &RunRecord::Prediction::name);
  if (found != record.predictions.end()) return *found;
  return record.predictions.emplace_back(RunRecord::Prediction{.name = std::string(name)});
}

// Where no effect was added, the model with effects is the one that was fitted anew.
void drop_repetition(RunRecord& record) {
  const auto with = std::ranges::find(record.predictions, model_words[2].second, &RunRecord::Prediction::name);
  const auto without = std::ranges::find(record.predictions, model_words[1].second, &RunRecord::Prediction::name);
  if (with != record.predictions.end() && without != record.predictions.end() && with->y == without->y)
    record.predictions.erase(with);
}

// The axis on which a row lies: the one of the three that has a value.
std::optional<std::pair<std::string_view, double>> place_of(const text::CsvTexts& table, std::size_t row) {
  for (const std::string_view axis : axes)
    if (table.has(axis))
      if (const auto value = table.number(axis, row)) return std::pair(axis, *value);
  return std::nullopt;
}

// The even step of the times; nothing where they are not even to a thousandth.
std::optional<double> even_interval(const std::vector<double>& times) {
  if (times.size() < 2) return std::nullopt;
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i)
    if (std::abs(times[i] - times[i - 1] - step) > 1e-3 * step) return std::nullopt;
  return step;
}

std::vector<std::string> colour_order() {
  std::vector<std::string> names{"measured"};
  for (const auto& [column, name] : model_words) names.emplace_back(name);
  return names;
}

// Values that are not numbers become straight between those beside them; at an end they are what is beside them.
void bridge(std::vector<double>& values) {
  const std::size_t n = values.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isnan(values[i])) continue;
    std::size_t end = i;
    while (end < n && std::isnan(values[end])) ++end;
    if (i == 0 && end == n) return;
    const double left = i > 0 ? values[i - 1] : values[end];
    const double right = end < n ? values[end] : left;
    const auto steps = static_cast<double>(end - i + 1);
    for (std::size_t k = i; k < end; ++k) values[k] = left + (right - left) * static_cast<double>(k - i + 1) / steps;
    i = end;
  }
}

std::string outliers_text(const RunRecord& record) {
  return record.outliers > 0 ? fmt::format(" Samples left out as outliers ({}) are bridged.", record.outliers)
                             : std::string();
}

Figure record_figure(const RunRecord& record, std::size_t number) {
  const Thinning thinning(record.x.size());
  Chart chart{
      .id = fmt::format("run-{}", number),
      .title = fmt::format("{} ({})", record.run, record.role == "fit" ? "fitted" : "held out of the fit"),
      .description = fmt::format("{} as measured and as each model predicts it.{}", record.channel, thinning.text()),
      .x_title = axis_title(record.axis),
      .y_title = record.channel,
      .series =
          {{.name = "measured", .x = thinning.of(record.x), .y = thinning.of(record.measured), .mark = Mark::dots}},
      .colour_order = colour_order()};
  for (const RunRecord::Prediction& each : record.predictions)
    chart.series.push_back({.name = each.name, .x = thinning.of(each.x), .y = thinning.of(each.y)});
  return figure_of(chart);
}

Figure residual_figure(const RunRecord& record, std::size_t number) {
  const Thinning thinning(record.x.size());
  Chart chart{.id = fmt::format("residual-{}", number),
              .title = fmt::format("{}: what each model leaves over", record.run),
              .description = "Measured less predicted." + outliers_text(record) + thinning.text(),
              .x_title = axis_title(record.axis),
              .y_title = "residual of " + record.channel,
              .colour_order = colour_order()};
  for (const RunRecord::Prediction& each : record.predictions)
    chart.series.push_back({.name = each.name, .x = thinning.of(each.x), .y = thinning.of(each.residual)});
  return figure_of(chart);
}

std::optional<Figure> spectrum_figure(const RunRecord& record, std::size_t number) {
  if (record.axis != "time_s") return std::nullopt;
  Chart chart{
      .id = fmt::format("spectrum-{}", number),
      .title = fmt::format("{}: spectrum of what is left over", record.run),
      .description = "Amplitude of each line of the residual's spectrum; noise alone is level." + outliers_text(record),
      .x_title = "frequency, Hz",
      .y_title = "amplitude of " + record.channel,
      .colour_order = colour_order()};
  for (const RunRecord::Prediction& each : record.predictions) {
    const std::optional<double> interval = even_interval(each.x);
    if (!interval) continue;
    const Spectrum spectrum = spectrum_of(each.residual, *interval);
    if (!spectrum.frequencies.empty())
      chart.series.push_back({.name = each.name, .x = spectrum.frequencies, .y = spectrum.amplitudes});
  }
  if (chart.series.empty()) return std::nullopt;
  return figure_of(chart);
}

constexpr std::size_t most_points = 1200;

}  // namespace

std::vector<RunRecord> read_runs(const std::filesystem::path& folder) {
  const text::CsvTexts table = read_table(folder / "residuals.csv");
  std::vector<RunRecord> records;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto place = place_of(table, row);
    const auto measured = table.number("measured", row);
    if (!place || !measured) continue;
    const std::string& run = table.column("run")[row];
    const std::string& channel = table.column("channel")[row];
    if (records.empty() || records.back().run != run || records.back().channel != channel)
      records.push_back(
          {.run = run, .role = table.column("role")[row], .channel = channel, .axis = std::string(place->first)});
    RunRecord& record = records.back();
    record.x.push_back(place->second);
    record.measured.push_back(*measured);
    const bool left_out = table.has("left_out") && table.number("left_out", row).value_or(0.0) != 0.0;
    if (left_out) ++record.outliers;
    for (const auto& [column, name] : model_words) {
      if (!table.has(column)) continue;
      const auto predicted = table.number(column, row);
      if (!predicted) continue;
      RunRecord::Prediction& prediction = prediction_of(record, name);
      prediction.x.push_back(place->second);
      prediction.y.push_back(*predicted);
      prediction.residual.push_back(left_out ? std::numeric_limits<double>::quiet_NaN() : *measured - *predicted);
    }
  }
  for (RunRecord& record : records) {
    for (RunRecord::Prediction& each : record.predictions) bridge(each.residual);
    drop_repetition(record);
  }
  return records;
}

std::vector<Figure> run_figures(const RunRecord& record, std::size_t number) {
  std::vector<Figure> figures{record_figure(record, number)};
  if (!record.predictions.empty()) figures.push_back(residual_figure(record, number));
  if (std::optional<Figure> spectrum = spectrum_figure(record, number)) figures.push_back(*std::move(spectrum));
  return figures;
}

Spectrum spectrum_of(const std::vector<double>& values, double interval) {
  if (values.size() < 8) return {};
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  std::vector<double> centred;
  for (const double value : values) centred.push_back(value - mean);
  std::vector<std::complex<double>> lines;
  Eigen::FFT<double> transform;
  transform.fwd(lines, centred);
  Spectrum out;
  const auto count = static_cast<double>(values.size());
  for (std::size_t i = 1; 2 * i <= values.size(); ++i) {
    out.frequencies.push_back(static_cast<double>(i) / (count * interval));
    // The line at half the sampling rate has no mirror image.
    out.amplitudes.push_back((2 * i == values.size() ? 1.0 : 2.0) * std::abs(lines[i]) / count);
  }
  return out;
}

Thinning::Thinning(std::size_t count) : stride_((count + most_points - 1) / most_points) {}

std::vector<double> Thinning::of(const std::vector<double>& values) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < values.size(); i += stride_) out.push_back(values[i]);
  return out;
}

std::string Thinning::text() const {
  return stride_ > 1 ? fmt::format(" One sample in {} is drawn.", stride_) : "";
}

}  // namespace coilwright::page

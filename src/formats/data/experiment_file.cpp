#include "coilwright/formats/data/experiment_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/text/number.hpp"
#include "coilwright/text/output/file_name.hpp"
#include "formats/data/experiment_parts.hpp"
#include "formats/data/run_words.hpp"
#include "formats/simulation/plausible_ranges.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement::data;
using namespace measurement::planning;

// Bounds far beyond any rig, and low enough that a wrong file is refused before it is simulated.
constexpr Rule angle_rule = Rule::between(-180.0, 180.0);  // deg
constexpr std::size_t most_points = 100'000;
constexpr std::size_t most_planned_runs = 1000;

// What holds for every run that does not say otherwise.
struct Defaults {
  std::optional<double> rate{};  // samples a second
  std::vector<std::string> measure{"bending_angle_deg"};
  RecordingClock clock{};
  InputHold hold{};
  InputUncertainty input_uncertainty{};
  double input_rate{};  // samples a second; 0: on the clock of the run
};

// The number in "theta2" for the stem "theta", from 1; nothing for another name.
std::optional<int> numbered(std::string_view name, std::string_view stem) {
  if (!name.starts_with(stem)) return std::nullopt;
  const std::string_view digits = name.substr(stem.size());
  const auto number = number_in<int>(digits);
  return number && *number >= 1 && digits.front() != '0' ? number : std::nullopt;
}

Channel channel_named(const std::string& name, const Node& node) {
  const auto split = units::split_unit(name);
  const std::string_view unit = split ? split->unit.suffix : "";
  if (split && (unit == "deg" || unit == "rad")) {
    if (split->quantity == "bending_angle") return {.name = name, .kind = ChannelKind::bending_angle};
    if (const auto joint = numbered(split->quantity, "theta"))
      return {.name = name, .kind = ChannelKind::joint_angle, .joint = *joint - 1};
  }
  if (split && (unit == "deg_s" || unit == "rad_s"))
    if (const auto joint = numbered(split->quantity, "omega"))
      return {.name = name, .kind = ChannelKind::joint_rate, .joint = *joint - 1};
  throw node.error("must be measured columns: bending_angle_deg, theta1_deg, .. or omega1_rad_s, ..");
}

// A data set numbers the columns of a quantity from 1, without a gap.
std::vector<std::string> read_measure(const Node& node) {
  std::vector<std::string> names;
  std::map<ChannelKind, int> next;
  for (const Node& element : node.elements(Length::at_least(1))) {
    const Channel channel = channel_named(element.text(), element);
    const int place = next[channel.kind]++;
    if (channel.kind == ChannelKind::bending_angle && place > 0) throw element.error("must not be there twice");
    if (channel.joint != place) throw element.error("must be numbered 1, 2, .. in turn");
    names.push_back(channel.name);
  }
  return names;
}

// How runs are recorded, where they do not say otherwise.
void read_recording(ObjectReader& in, RecordingClock& clock, InputHold& hold, InputUncertainty& input_uncertainty,
                    double& input_rate) {
  input_uncertainty = read_input_uncertainty(in, input_uncertainty);
  clock.exposure = in.quantity_or("exposure_s", clock.exposure, time_rule);
  clock.offset_sigma = in.quantity_or("clock_offset_s", clock.offset_sigma, time_rule);
  clock.rate_sigma = in.number_or("clock_rate", clock.rate_sigma, Rule::between(0.0, 0.2));
  if (const auto how = in.find("input_hold")) hold = read_input_hold(*how);
  input_rate = in.quantity_or("input_rate_Hz", input_rate, frequency_rule);
}

// The name of a run is that of its file, beside dataset.json.
std::string read_file_name(const Node& node) {
  const std::string& name = node.name();
  if (fault_of_file_name(name) || !name.ends_with(".csv") || name.starts_with('.'))
    throw node.error("must be a plain file name that ends in .csv");
  return name;
}

void require_samples(const ObjectReader& in, const PlannedRun& planned) {
  const double samples = planned.duration * planned.rate;
  if (samples < 5.0 || samples > simulation::most_samples)
    throw in.node().error_without_value(fmt::format("duration_s times sampling_rate_Hz must be from 5 to {}; got {:g}",
                                                    simulation::most_samples, samples));
}

// A change after the end of its run is a slip of a number: nothing of it would be recorded.
void require_change_within(const Node& input, double duration) {
  const auto require = [duration](const std::optional<Node>& shape, std::string_view key) {
    if (!shape) return;
    const auto time = shape->find(key);
    if (time && time->number() >= duration)
      throw time->error(fmt::format("must be below the run's duration, {:g} s", duration));
  };
  require(input.find("step"), "at_s");
  require(input.find("release"), "at_s");
  require(input.find("hold"), "from_s");
}

// A camera closes its shutter before it opens it again.
void require_exposure_within_a_frame(const ObjectReader& in, const PlannedRun& planned) {
  const double exposure = planned.plan.clock.exposure;
  if (exposure * planned.rate > 1.0 + 1e-9)
    throw in.node().error_without_value(fmt::format(
        "exposure_s must be at most the time between two samples, {:g} s; got {:g}", 1.0 / planned.rate, exposure));
}

double read_rate(ObjectReader& in, const Defaults& defaults) {
  return defaults.rate ? in.quantity_or("sampling_rate_Hz", *defaults.rate, frequency_rule)
                       : in.quantity("sampling_rate_Hz", frequency_rule);
}

std::vector<Channel> read_channels(ObjectReader& in, const Defaults& defaults) {
  const auto own = in.find("measure");
  std::vector<Channel> channels;
  for (const std::string& name : own ? read_measure(*own) : defaults.measure)
    channels.push_back(channel_named(name, in.node()));
  return channels;
}

void read_time_axis(ObjectReader& in, const Defaults& defaults, PlannedRun& planned) {
  planned.rate = read_rate(in, defaults);
  planned.input = read_input_shape(in.at("input"), planned.plan.drive);
  const auto* table = in.at("input").find("file") ? std::get_if<TableShape>(&planned.input) : nullptr;
  const double of_file = table == nullptr ? 0.0 : table->times.back() - table->times.front();
  planned.duration =
      of_file > 0.0 ? in.quantity_or("duration_s", of_file, duration_rule) : in.quantity("duration_s", duration_rule);
  require_samples(in, planned);
  require_change_within(in.at("input"), planned.duration);
}

void read_transient(ObjectReader& in, const Defaults& defaults, PlannedRun& planned) {
  Run& run = planned.plan;
  const auto drive = in.find("drive");
  run.drive = drive ? read_drive(*drive) : Drive::current;
  const auto start = in.find("start");
  run.start = start ? read_start(*start) : Start::at_rest;
  run.clock = defaults.clock;
  run.hold = defaults.hold;
  run.input_uncertainty = defaults.input_uncertainty;
  planned.input_rate = defaults.input_rate;
  read_recording(in, run.clock, run.hold, run.input_uncertainty, planned.input_rate);
  if (const auto rig = in.find("rig")) run.rig = read_rig(*rig);
  if (const auto angles = in.find("start_angles_deg")) {
    if (run.start == Start::at_rest) throw angles->error("must not be there where the start is \"at_rest\"");
    if (planned.input_rate > 0.0 || run.clock.offset_sigma > 0.0 || run.clock.exposure > 0.0)
      throw angles->error_without_value(
          "must not be there beside input_rate_Hz, clock_offset_s or exposure_s: the time of the release is that of "
          "the first sample");
    planned.start_angles = angles->quantities(Length::at_least(1), angle_rule);
  }
  read_time_axis(in, defaults, planned);
  require_exposure_within_a_frame(in, planned);
  const std::string_view one = run.drive == Drive::torque ? "joint" : "coil";
  if (const auto only = in.find(one)) {
    if (run.drive == Drive::voltage) throw only->error("must not be there under a voltage, which all coils share");
    if (std::holds_alternative<TableShape>(planned.input))
      throw only->error("must not be there beside a table, whose columns say what is driven");
    planned.only = only->integer(Rule::at_least(1)) - 1;
  }
  run.channels = read_channels(in, defaults);
}

// Nothing moves: only how long and how often the camera looks.
void read_still(ObjectReader& in, const Defaults& defaults, PlannedRun& planned) {
  planned.rate = read_rate(in, defaults);
  planned.duration = in.quantity("duration_s", duration_rule);
  require_samples(in, planned);
  planned.plan.channels = read_channels(in, defaults);
}

void read_temperature(ObjectReader& in, const Defaults& defaults, PlannedRun& planned) {
  read_time_axis(in, defaults, planned);
  const auto* table = std::get_if<TableShape>(&planned.input);
  if (table != nullptr && table->rows.front().size() != 1)
    throw in.at("input").error_without_value("must have one current for all coils");
  planned.plan.channels = {{.name = "temperature_degC", .kind = ChannelKind::temperature}};
}

std::vector<double> read_points(ObjectReader& in, std::string_view key, const Rule& rule) {
  return in.quantities(key, Length::from_to(1, most_points), rule);
}

// Every angle under every current.
void read_static_torque(ObjectReader& in, Run& run) {
  const std::vector<double> angles = read_points(in, "angles_deg", angle_rule);
  const std::vector<double> currents = read_points(in, "currents_A", level_rule);
  if (angles.size() * currents.size() > most_points)
    throw in.node().error_without_value(fmt::format("must make at most {} points", most_points));
  for (const double current : currents)
    for (const double angle : angles) {
      run.angles.push_back(angle);
      run.inputs.push_back({current});
    }
  run.channels = {{.name = "torque_Nmm", .kind = ChannelKind::torque}};
}

void read_bench(ObjectReader& in, Run& run) {
  if (run.kind == RunKind::static_torque) {
    read_static_torque(in, run);
  } else if (run.kind == RunKind::joint_stiffness) {
    run.angles = read_points(in, "angles_deg", angle_rule);
    run.channels = {{.name = "torque_Nmm", .kind = ChannelKind::torque}};
  } else {
    for (const double current : read_points(in, "currents_A", level_rule)) run.inputs.push_back({current});
    run.channels = {{.name = "force_N", .kind = ChannelKind::force}};
  }
}

PlannedRun read_run(const Node& node, const Defaults& defaults) {
  return read_object(node, [&](ObjectReader& in) {
    PlannedRun planned;
    planned.plan.name = read_file_name(in.at("file"));
    const auto kind = in.find("kind");
    planned.plan.kind = kind ? read_run_kind(*kind) : RunKind::transient;
    planned.validate = read_is_validate(in, planned.plan.kind == RunKind::still);
    if (planned.plan.kind == RunKind::transient)
      read_transient(in, defaults, planned);
    else if (planned.plan.kind == RunKind::still)
      read_still(in, defaults, planned);
    else if (planned.plan.kind == RunKind::temperature)
      read_temperature(in, defaults, planned);
    else
      read_bench(in, planned.plan);
    return planned;
  });
}

Experiment read_experiment_file(const Document& document) {
  return read_object(document.root(), [](ObjectReader& in) {
    in.literal("format", "experiment/1");
    Experiment experiment;
    experiment.name = in.at("name").name();
    (void)in.text_or("description", "");
    Defaults defaults;
    defaults.rate = in.optional_quantity("sampling_rate_Hz", frequency_rule);
    if (const auto measure = in.find("measure")) defaults.measure = read_measure(*measure);
    experiment.instruments = read_instruments(in);
    read_recording(in, defaults.clock, defaults.hold, defaults.input_uncertainty, defaults.input_rate);
    const std::vector<Node> runs = in.elements("runs", Length::from_to(1, most_planned_runs));
    // A default whose key is misspelt would be missing in every run.
    in.finish();
    std::vector<std::string> names;
    std::vector<const Node*> by;  // which run writes each
    for (const Node& element : runs) {
      experiment.runs.push_back(read_run(element, defaults));
      const PlannedRun& planned = experiment.runs.back();
      names.push_back(planned.plan.name);
      if (planned.input_rate > 0.0) names.push_back(input_file_name(planned.plan.name));
      by.resize(names.size(), &element);
    }
    if (const auto fault = fault_of_file_names(names)) {
      const Node file = *by[fault->index]->find("file");
      if (file.text() == names[fault->index]) throw file.error(fault->rule);
      throw file.error(
          fmt::format("must be another name: its input is written to {}, which is there already", names[fault->index]));
    }
    return experiment;
  });
}

}  // namespace

Experiment read_experiment(const std::filesystem::path& path) {
  return read_experiment_file(read_json(path));
}

Experiment parse_experiment(std::string_view text, std::string file) {
  return read_experiment_file(parse_json(text, std::move(file)));
}

}  // namespace coilwright::formats

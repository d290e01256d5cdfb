#include "coilwright/formats/data/dataset_file.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "coilwright/formats/data/run_file.hpp"
#include "coilwright/measurement/data/data_quality.hpp"
#include "coilwright/measurement/data/hold_out.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/data/run_words.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::Dataset;
using measurement::data::Run;
using measurement::data::RunKind;
using measurement::data::Start;

// Far beyond any set that a rig fills, and near enough that a wrong file is refused at once.
constexpr std::size_t most_runs = 10'000;

// In the column's unit. Outside, no instrument: a fit would drown in it, or overflow.
constexpr Rule sigma_rule = Rule::between(1e-12, 1e12);

enum class Role { fit, validate };

// The columns decide; the entry must say the same. Nothing is commanded where a hinge is held open by hand.
void check_drive(const Run& run, const Node& node) {
  if (run.kind != RunKind::joint_stiffness && read_drive(node) != run.drive)
    throw node.error("must be \"" + std::string(name_of(run.drive)) + "\", as the input column of the file says");
}

void check_start(const Run& run, const Node& node) {
  const auto has = [&](measurement::data::ChannelKind quantity) {
    return std::ranges::count(run.channels, quantity, &measurement::data::Channel::kind) > 0;
  };
  const bool angle =
      has(measurement::data::ChannelKind::bending_angle) || has(measurement::data::ChannelKind::joint_angle);
  if (run.kind == RunKind::transient && run.start == Start::measured && !angle)
    throw node.error("must not be \"measured\" where no angle is measured");
}

void check_window(const Run& run, const Node& node) {
  if (run.times.size() < 2) return;
  const double shortest = (run.times.back() - run.times.front()) / static_cast<double>(run.times.size() - 1);
  if (*run.window <= shortest) throw node.error("must exceed the mean interval between samples");
}

struct Entry {
  RunFile file;
  Role role{};
};

Entry read_entry(const Node& node, std::set<std::filesystem::path>& met) {
  return read_object(node, [&](ObjectReader& in) {
    const Node file = in.at("file");
    RunEntry entry{.name = file.text()};
    entry.kind = read_run_kind(in.at("kind"));
    const Role role = in.choice<Role>("role", {{"fit", Role::fit}, {"validate", Role::validate}});
    const auto start = in.find("start");
    entry.start = start ? read_start(*start) : Start::at_rest;
    const auto window = in.find_not_null("window_s");
    if (window) entry.window = window->quantity(positive);
    if (const auto sigma = in.find_not_null("sigma")) entry.sigma = sigma->number(sigma_rule);
    const auto drive = entry.kind == RunKind::transient ? std::optional(in.at("drive")) : in.find("drive");
    if (drive) (void)read_drive(*drive);
    std::error_code unreadable;
    const auto path = std::filesystem::weakly_canonical(file.path(), unreadable);
    if (!met.insert(unreadable ? file.path() : path).second) throw file.error("must not be there twice");
    in.finish();  // a mistake in this entry is told before one in its file
    Entry out{.file = read_run(file.path(), entry), .role = role};
    if (drive) check_drive(out.file.run, *drive);
    if (start) check_start(out.file.run, *start);
    if (window) check_window(out.file.run, *window);
    return out;
  });
}

std::vector<std::string> read_calibrate(ObjectReader& in) {
  const auto node = in.find("calibrate");
  if (!node) return {"joint_stiffness", "joint_damping"};
  std::vector<std::string> names;
  for (const Node& element : node->elements()) {
    const std::string& name = element.text();
    if (name != "joint_stiffness" && name != "joint_damping" && !name.starts_with('/'))
      throw element.error(R"(must be "joint_stiffness", "joint_damping" or a JSON pointer into the actuator file)");
    if (std::ranges::count(names, name) > 0) throw element.error("must not be there twice");
    names.push_back(name);
  }
  return names;
}

Dataset read_runs(const Node& node, std::vector<std::filesystem::path>& files) {
  std::set<std::filesystem::path> met;
  std::map<std::string, InputError> objections;
  std::vector<Run> validate;
  Dataset data;
  for (const Node& element : node.elements(Length::from_to(1, most_runs))) {
    Entry entry = read_entry(element, met);
    if (entry.file.objection) objections.emplace(entry.file.run.name, *entry.file.objection);
    (entry.role == Role::fit ? data.fit : validate).push_back(std::move(entry.file.run));
  }
  files.assign(met.begin(), met.end());
  if (data.fit.empty()) throw node.error_without_value("needs at least one fit run");
  data.validate = measurement::data::SealedRuns(std::move(validate));
  data = measurement::data::with_runs_held_out(std::move(data));
  for (const Run& run : data.fit) {
    if (const auto found = objections.find(run.name); found != objections.end()) throw found->second;
    std::ranges::move(measurement::data::data_quality_warnings(run), std::back_inserter(data.warnings));
  }
  return data;
}

DatasetFile read_document(const Document& document) {
  return read_object(document.root(), [&](ObjectReader& in) {
    in.literal("format", "measured-data/1");
    DatasetFile out{.file = document.root().file()};
    std::string name = in.text_or("name", "");
    if (const auto actuator = in.find_not_null("actuator")) out.actuator = actuator->path();
    out.calibrate = read_calibrate(in);
    const Node runs = in.at("runs");
    in.finish();
    out.data = read_runs(runs, out.run_files);
    out.data.name = std::move(name);
    return out;
  });
}

}  // namespace

DatasetFile read_dataset(const std::filesystem::path& path) {
  std::error_code unreadable;
  const bool folder = std::filesystem::is_directory(path, unreadable);
  return read_document(read_json(folder ? path / "dataset.json" : path));
}

DatasetFile parse_dataset(std::string_view text, std::string file) {
  return read_document(parse_json(text, std::move(file)));
}

}  // namespace coilwright::formats

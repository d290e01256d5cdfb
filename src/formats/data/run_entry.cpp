#include "formats/data/run_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "coilwright/text/json/object_reader.hpp"
#include "formats/data/layout_format.hpp"
#include "formats/data/named_table.hpp"
#include "formats/data/run_words.hpp"
#include "formats/simulation/plausible_ranges.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::Run;
using measurement::data::RunKind;
using measurement::data::Start;

constexpr Rule rate_rule = Rule::between(0.0, 1.0);  // relative

// The columns decide; the entry must say the same. Nothing is commanded where a hinge is held open by hand.
void check_drive(const Run& run, const Node& node) {
  if (run.kind != RunKind::joint_stiffness && run.kind != RunKind::still && read_drive(node) != run.drive)
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

void check_input_sigma(const Run& run, const Node& node) {
  const std::size_t given = run.input_uncertainty.sigma.size();
  if (given > 0 && given != run.inputs.front().size())
    throw node.error_without_value(
        fmt::format("input_sigma must be one number, or one for each of the {} columns of the input; got {} numbers",
                    run.inputs.front().size(), given));
}

void check_exposure(const Run& run, const Node& node) {
  if (run.clock.exposure >= run.times.back() - run.times.front()) throw node.error("must be shorter than the record");
}

// What an object says of the layout of its file, over what stands above it.
FileLayout read_file_layout(ObjectReader& in, const CsvLayout& above) {
  const LayoutEntry entry = read_layout(in, above);
  FileLayout out{.layout = entry.layout};
  for (const auto& [source, node] : entry.named) {
    const std::string within = node.pointer().substr(in.node().pointer().size() + 1);
    out.must_fit.emplace(source, within.substr(0, within.find('/')));
  }
  return out;
}

// A path, or an object with one and the layout of that file.
void read_input_file(const Node& node, RunEntry& entry) {
  if (node.kind() != Node::Kind::object) {
    entry.input_file = node.path();
    return;
  }
  read_object(node, [&](ObjectReader& in) {
    entry.input_file = in.path("file");
    entry.input_layout = read_file_layout(in, entry.layout.layout);
    return 0;
  });
}

// What only a camera's record of a motion has; null counts as absent.
std::optional<Node> find_of_motion(ObjectReader& in, std::string_view key, RunKind kind) {
  auto node = in.find_not_null(key);
  if (node && kind != RunKind::transient) throw node->error_without_value("must be there for a transient only");
  return node;
}

// The keys of a transient about its clocks, its input and its rig; the node of its exposure.
std::optional<Node> read_recording(ObjectReader& in, RunEntry& entry,
                                   const measurement::data::InputUncertainty& usual) {
  for (const char* key : {"input_sigma", "input_correlation_s"}) (void)find_of_motion(in, key, entry.kind);
  if (entry.kind == RunKind::transient) entry.input_uncertainty = read_input_uncertainty(in, usual);
  if (const auto file = find_of_motion(in, "input_file", entry.kind)) read_input_file(*file, entry);
  if (const auto hold = find_of_motion(in, "input_hold", entry.kind)) entry.hold = read_input_hold(*hold);
  if (const auto shift = find_of_motion(in, "clock_offset_s", entry.kind))
    entry.clock_offset = shift->quantity(time_rule);
  if (const auto rate = find_of_motion(in, "clock_rate", entry.kind)) entry.clock_rate = rate->number(rate_rule);
  if (const auto rig = find_of_motion(in, "rig", entry.kind)) entry.rig = read_rig(*rig);
  auto exposure = find_of_motion(in, "exposure_s", entry.kind);
  if (exposure) entry.exposure = exposure->quantity(time_rule);
  return exposure;
}

}  // namespace

RunInSet read_run_in_set(const Node& node, std::map<std::filesystem::path, std::filesystem::path>& met,
                         const CsvLayout& set, const measurement::data::InputUncertainty& usual) {
  return read_object(node, [&](ObjectReader& in) {
    const Node file = in.at("file");
    RunEntry entry{.name = file.name()};
    entry.kind = read_run_kind(in.at("kind"));
    const bool still = entry.kind == RunKind::still;
    const bool validate = read_is_validate(in, still);
    const auto start = in.find("start");
    entry.start = start ? read_start(*start) : Start::at_rest;
    const auto window = find_of_motion(in, "window_s", still ? entry.kind : RunKind::transient);
    if (window) entry.window = window->quantity(positive);
    if (const auto sigma = in.find_not_null("sigma")) entry.sigma = sigma->number(sigma_rule);
    const auto drive = entry.kind == RunKind::transient ? std::optional(in.at("drive")) : in.find("drive");
    if (drive) (void)read_drive(*drive);
    entry.layout = read_file_layout(in, set);
    const auto exposure = read_recording(in, entry, usual);
    std::error_code unreadable;
    const auto path = std::filesystem::weakly_canonical(file.path(), unreadable);
    if (!met.try_emplace(unreadable ? file.path() : path, file.path()).second)
      throw file.error("must not be there twice");
    in.finish();  // a mistake in this entry is told before one in its file
    RunInSet out{.file = read_named_table(file, [&](const auto& table) { return read_run(table, entry); }),
                 .validate = validate,
                 .input_file = entry.input_file};
    if (drive) check_drive(out.file.run, *drive);
    if (start) check_start(out.file.run, *start);
    if (window) check_window(out.file.run, *window);
    if (exposure) check_exposure(out.file.run, *exposure);
    check_input_sigma(out.file.run, node);
    return out;
  });
}

}  // namespace coilwright::formats

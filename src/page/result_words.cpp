#include "page/result_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "coilwright/page/chart.hpp"
#include "coilwright/report/front_text.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/problem/options.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::page {

using text::Node;

namespace {

std::optional<text::Document> provenance_in(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "provenance.json";
  if (!std::filesystem::is_regular_file(file)) return std::nullopt;
  return text::read_json(file);
}

}  // namespace

Node member_of(const Node& object, std::string_view key) {
  if (const auto found = object.find(key)) return *found;
  throw object.error_without_value(fmt::format("must have \"{}\" (docs/formats.md)", key));
}

Node only_member_of(const Node& object) {
  const std::vector<Node> members = object.members();
  if (members.size() != 1) throw object.error_without_value("must have exactly one member (docs/formats.md)");
  return members.front();
}

std::string cell_of(const Node& node) {
  switch (node.kind()) {
    case Node::Kind::number:
      return short_number(node.number());
    case Node::Kind::text:
      return node.text();
    case Node::Kind::boolean:
      return node.boolean() ? "yes" : "no";
    default:
      return "-";
  }
}

std::string cell_of(const Node& object, std::string_view key) {
  return cell_of(member_of(object, key));
}

std::string limit_text(const Node& constraint) {
  const std::string quantity = member_of(constraint, "quantity").text();
  if (const auto most = constraint.find("at_most")) return fmt::format("{} <= {}", quantity, cell_of(*most));
  return fmt::format("{} >= {}", quantity, cell_of(constraint, "at_least"));
}

double margin_percent(const Node& constraint) {
  const auto most = constraint.find("at_most");
  double scale = std::abs((most ? *most : member_of(constraint, "at_least")).number());
  if (scale == 0.0) {
    const auto* quantity = simulation::standard_quantities().find(member_of(constraint, "quantity").text());
    scale = quantity == nullptr ? 1.0 : quantity->scale;
  }
  return 100.0 * member_of(constraint, "margin").number() / scale;
}

std::string members_text(const Node& object) {
  std::vector<std::string> parts;
  for (const Node& member : object.members()) parts.push_back(fmt::format("{} {}", member.key(), cell_of(member)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string only_member_text(const Node& object) {
  const Node member = only_member_of(object);
  return fmt::format("{} {}", member.key(), cell_of(member));
}

std::string ids_text(const Node& list) {
  std::vector<std::string> ids;
  for (const Node& each : list.elements()) ids.push_back(each.text());
  return ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, " and "));
}

bool is_conditional(const Node& limit) {
  const auto conditional = limit.find("conditional");
  return conditional && conditional->boolean();
}

bool was_interrupted(const Node& result) {
  const auto reason = result.find("stop_reason");
  return reason && reason->text() == "interrupted";
}

std::vector<std::string> cautions_of_parts(const Node& result) {
  const auto limits = result.find("broken_part_limits");
  std::vector<std::string> broken;
  std::vector<std::string> conditional;
  for (const Node& each : limits ? limits->elements() : std::vector<Node>())
    (is_conditional(each) ? conditional : broken)
        .push_back(fmt::format("{} of them break {}: {}", cell_of(each, "designs"), cell_of(each, "quantity"),
                               cell_of(each, "consequence")));
  std::vector<std::string> out;
  if (was_interrupted(result)) out.emplace_back(interrupted_caution);
  if (!broken.empty())
    out.push_back(fmt::format("BEWARE: they break limits of their parts. {}.", fmt::join(broken, "; ")));
  if (!conditional.empty()) out.push_back(fmt::format("MIND: {}.", fmt::join(conditional, "; ")));
  return out;
}

bool is_feasible(const Node& result) {
  return member_of(result, "feasible").boolean();
}

std::vector<Objective> objectives_of(const Node& result, text::Length count) {
  std::vector<Objective> out;
  for (const Node& each : member_of(result, "objectives").elements(count)) {
    const Node member = only_member_of(each);
    if (member.key() != "maximise" && member.key() != "minimise")
      throw each.error_without_value(R"(must have "maximise" or "minimise" (docs/formats.md))");
    out.push_back({.name = member.text(), .largest = member.key() == "maximise"});
  }
  return out;
}

Objective objective_of(const Node& result) {
  return objectives_of(result, text::Length::exactly(1)).front();
}

std::string origin_text(const std::filesystem::path& folder, std::string_view made_by) {
  std::string out = fmt::format("Page by {}.", made_by);
  const auto document = provenance_in(folder);
  if (!document) return out;
  const Node root = document->root();
  const auto word = [&](const char* key) {
    const auto node = root.find(key);
    return node ? cell_of(*node) : std::string("-");
  };
  out += fmt::format(" Results of {} {}, commit {}", word("command"), word("version"), word("commit").substr(0, 12));
  // Null where nothing is drawn.
  if (const auto seed = root.find("seed"); seed && !seed->is_null()) out += fmt::format(", seed {}", cell_of(*seed));
  return out + '.';
}

text::CsvTexts read_table(const std::filesystem::path& file) {
  return text::read_csv_texts(file, [](std::string_view) { return true; });
}

void require_rows(const text::CsvTexts& table, std::size_t counted) {
  if (table.rows() == counted) return;
  throw table.error(
      fmt::format("must have the {} rows that result.json beside it counts; got {}", counted, table.rows()));
}

std::size_t evaluations_of(const Node& result) {
  const Node counts = member_of(result, "evaluations");
  std::size_t all = 0;
  for (const char* status : {"ok", "infeasible", "failed"}) all += member_of(counts, status).integer<std::uint32_t>();
  return all;
}

std::string end_of_search(const Node& result, bool of_front) {
  using enum sizing::StopReason;
  const auto gain = result.find("late_gain");
  if (!gain) return {};
  const Node counts = member_of(result, "evaluations");
  const auto of_ends = counts.find("of_ends");
  report::SearchEnd end{.feasible = member_of(counts, "ok").integer<std::uint32_t>(),
                        .of_ends = of_ends ? of_ends->integer<std::uint32_t>() : 0,
                        .late_gain = gain->is_null() ? std::nullopt : std::optional(gain->number()),
                        .of_front = of_front};
  const auto reason = result.find("search_stop_reason");
  const std::string name = (reason ? *reason : member_of(result, "stop_reason")).text();
  for (const sizing::StopReason each : {evaluation_limit, space_exhausted, converged, interrupted})
    if (name == sizing::name_of(each)) {
      end.reason = each;
      return " " + report::to_text(end);
    }
  return {};
}

std::vector<std::string> input_lines(const std::filesystem::path& folder) {
  std::vector<std::string> out;
  const auto document = provenance_in(folder);
  if (!document) return out;
  const Node root = document->root();
  if (const auto inputs = root.find("inputs"))
    for (const Node& input : inputs->elements())
      out.push_back(fmt::format("{}: SHA-256 {}", cell_of(input, "file"), cell_of(input, "sha256").substr(0, 12)));
  return out;
}

std::vector<std::string> texts_of(const Node& object, std::string_view key) {
  std::vector<std::string> out;
  for (const Node& each : member_of(object, key).elements()) out.push_back(each.text());
  return out;
}

}  // namespace coilwright::page

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

std::string ids_text(const Node& list) {
  std::vector<std::string> ids;
  for (const Node& each : list.elements()) ids.push_back(each.text());
  return ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, " and "));
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

}  // namespace coilwright::page

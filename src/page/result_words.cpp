#include "page/result_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "coilwright/page/chart.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::page {

using text::Node;

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

std::string limit_text(const Node& constraint) {
  const std::string quantity = constraint.find("quantity").value().text();
  if (const auto most = constraint.find("at_most")) return fmt::format("{} <= {}", quantity, cell_of(*most));
  return fmt::format("{} >= {}", quantity, cell_of(constraint.find("at_least").value()));
}

double margin_percent(const Node& constraint) {
  const auto most = constraint.find("at_most");
  double scale = std::abs((most ? *most : constraint.find("at_least").value()).number());
  if (scale == 0.0) {
    const auto* quantity = simulation::standard_quantities().find(constraint.find("quantity").value().text());
    scale = quantity == nullptr ? 1.0 : quantity->scale;
  }
  return 100.0 * constraint.find("margin").value().number() / scale;
}

std::string members_text(const Node& object) {
  std::vector<std::string> parts;
  for (const Node& member : object.members()) parts.push_back(fmt::format("{} {}", member.key(), cell_of(member)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string first_member_text(const Node& object) {
  const std::vector<Node> members = object.members();
  return members.empty() ? "-" : fmt::format("{} {}", members.front().key(), cell_of(members.front()));
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
        .push_back(fmt::format("{} of them break {}: {}", cell_of(each.find("designs").value()),
                               cell_of(each.find("quantity").value()), cell_of(each.find("consequence").value())));
  std::vector<std::string> out;
  if (was_interrupted(result)) out.emplace_back(interrupted_caution);
  if (!broken.empty())
    out.push_back(fmt::format("BEWARE: the study does not set limits of the parts. {}.", fmt::join(broken, "; ")));
  if (!conditional.empty()) out.push_back(fmt::format("MIND: {}.", fmt::join(conditional, "; ")));
  return out;
}

bool is_feasible(const Node& result) {
  return result.find("feasible").value().boolean();
}

Objective objective_of(const Node& result) {
  const Node first = result.find("objectives").value().elements().front();
  const Node member = first.members().front();
  return {.name = member.text(), .largest = member.key() == "maximise"};
}

std::string origin_text(const std::filesystem::path& folder, std::string_view made_by) {
  std::string out = fmt::format("Page by {}.", made_by);
  const std::filesystem::path file = folder / "provenance.json";
  if (!std::filesystem::is_regular_file(file)) return out;
  const text::Document document = text::read_json(file);
  const Node root = document.root();
  const auto word = [&](const char* key) {
    const auto node = root.find(key);
    return node ? cell_of(*node) : std::string("-");
  };
  out += fmt::format(" Results of {} {}, commit {}", word("command"), word("version"), word("commit").substr(0, 12));
  // Null where nothing is drawn.
  if (const auto seed = root.find("seed"); seed && !seed->is_null()) out += fmt::format(", seed {}", cell_of(*seed));
  out += '.';
  if (const auto inputs = root.find("inputs"))
    for (const Node& input : inputs->elements())
      out += fmt::format(" {}: SHA-256 {}.", cell_of(input.find("file").value()),
                         cell_of(input.find("sha256").value()).substr(0, 12));
  return out;
}

}  // namespace coilwright::page

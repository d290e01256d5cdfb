#include "coilwright/report/simulation/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/text/markup.hpp"
#include "coilwright/text/one_line.hpp"

namespace coilwright::report {
namespace {

using text::Json;
using text::Node;
using text::ObjectReader;

struct TextOf {
  std::size_t indent{};

  std::string operator()(const Lines& lines) const { return lines.text; }
  std::string operator()(const TableBlock& block) const {
    TextTable table;
    if (block.headed) table.row(block.table.header);
    for (const std::vector<std::string>& row : block.table.rows) table.row(row);
    return table.text(indent + block.further_in, block.align);
  }
  std::string operator()(const BarChart&) const { return {}; }
};

struct HtmlOf {
  std::string operator()(const BarChart&) const { return {}; }
  std::string operator()(const auto& block) const { return to_html(block); }
};

Json texts_json(const std::vector<std::string>& texts) {
  return Json::list(texts);
}

struct JsonOf {
  Json operator()(const Lines& lines) const { return lines.text; }
  Json operator()(const TableBlock& block) const {
    return Json::object({{"caption", block.caption},
                         {"header", texts_json(block.table.header)},
                         {"rows", Json::list(block.table.rows, texts_json)}});
  }
  Json operator()(const BarChart& chart) const {
    return Json::object({{"id", chart.id},
                         {"title", chart.title},
                         {"description", chart.description},
                         {"value_title", chart.value_title},
                         {"label_title", chart.label_title},
                         {"symbols", chart.symbols},
                         {"bars", Json::list(chart.bars, [](const Bar& bar) {
                            return Json::object({{"label", bar.label}, {"value", bar.value}, {"group", bar.group}});
                          })}});
  }
};

std::vector<std::string> texts_of(const Node& list, text::Length length = {}) {
  std::vector<std::string> out;
  for (const Node& each : list.elements(length)) out.push_back(each.text());
  return out;
}

TableBlock read_table(ObjectReader& in) {
  TableBlock out{.caption = in.text("caption"), .table = {.header = texts_of(in.at("header"))}};
  for (const Node& row : in.elements("rows"))
    out.table.rows.push_back(texts_of(row, text::Length::exactly(out.table.header.size())));
  return out;
}

Bar read_bar(ObjectReader& in) {
  return {.label = in.text("label"), .value = in.number("value"), .group = in.text("group")};
}

BarChart read_chart(ObjectReader& in) {
  BarChart out{.id = in.text("id"),
               .title = in.text("title"),
               .description = in.text("description"),
               .value_title = in.text("value_title"),
               .label_title = in.text("label_title"),
               .symbols = in.at("symbols").boolean()};
  for (const Node& each : in.elements("bars")) out.bars.push_back(text::read_object(each, read_bar));
  return out;
}

std::variant<Lines, TableBlock, BarChart> read_block(const Node& node) {
  if (node.kind() == Node::Kind::text) return Lines{node.text()};
  if (node.kind() == Node::Kind::object && node.find("rows")) return text::read_object(node, read_table);
  return text::read_object(node, read_chart);
}

Section read_section(ObjectReader& in) {
  Section out{.id = in.text("id"), .title = in.text("title")};
  for (const Node& each : in.elements("blocks")) out.blocks.push_back(read_block(each));
  return out;
}

}  // namespace

void Section::say(const std::string& lines) {
  if (lines.empty()) return;
  if (blocks.empty() || !std::holds_alternative<Lines>(blocks.back())) blocks.emplace_back(Lines{});
  std::get<Lines>(blocks.back()).text += lines;
}

std::string to_text(const Section& section) {
  std::string out = section.title.empty() ? "" : section.title + '\n';
  for (const auto& block : section.blocks) out += std::visit(TextOf{section.title.empty() ? 0U : 2U}, block);
  return out;
}

std::string to_text(const Document& document) {
  std::vector<std::string> parts;
  for (const std::string& line : {document.title, document.verdict})
    if (!line.empty()) parts.push_back(line + '\n');
  parts.insert(parts.end(), document.cautions.begin(), document.cautions.end());
  for (const Section& each : document.sections)
    if (!each.blocks.empty()) parts.push_back(to_text(each));
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : "\n") + part;
  return out;
}

std::string to_html(const Lines& lines) {
  std::string out;
  std::size_t level = 0;
  const auto go_to = [&](std::size_t wanted) {
    for (; level > wanted; --level) out += "</li></ul>\n";
  };
  for (const std::string& line : text::lines_of(lines.text)) {
    const std::size_t start = line.find_first_not_of(' ');
    if (start == std::string::npos) continue;
    const std::size_t wanted = std::min(start / 2, level + 1);
    const std::string said = text::escaped(std::string_view(line).substr(start));
    const bool opens = wanted > level;
    go_to(wanted);
    if (opens)
      out += "<ul><li>" + said, ++level;
    else
      out += wanted > 0 ? "</li>\n<li>" + said : "<p>" + said + "</p>\n";
  }
  go_to(0);
  return out;
}

std::string to_html(const TableBlock& block) {
  return fmt::format("<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n{}</div>\n",
                     text::escaped(block.caption),
                     text::html_table(block.table.header, block.table.rows, block.caption));
}

std::string to_html(const Document& document) {
  std::string out = to_html(Lines{document.title + '\n' + document.verdict});
  for (const std::string& caution : document.cautions) out += to_html(Lines{caution});
  for (const Section& section : document.sections) {
    if (section.blocks.empty()) continue;
    out += fmt::format("<h4>{}</h4>\n", text::escaped(section.title));
    for (const auto& block : section.blocks) out += std::visit(HtmlOf{}, block);
  }
  return out;
}

Json to_json(const Document& document) {
  return Json::object({{"title", document.title},
                       {"verdict", document.verdict},
                       {"cautions", texts_json(document.cautions)},
                       {"sections", Json::list(document.sections, [](const Section& section) {
                          return Json::object({{"id", section.id},
                                               {"title", section.title},
                                               {"blocks", Json::list(section.blocks, [](const auto& block) {
                                                  return std::visit(JsonOf{}, block);
                                                })}});
                        })}});
}

Document read_document(const Node& node) {
  return text::read_object(node, [](ObjectReader& in) {
    Document out{.title = in.text("title"), .verdict = in.text("verdict"), .cautions = texts_of(in.at("cautions"))};
    for (const Node& each : in.elements("sections")) out.sections.push_back(text::read_object(each, read_section));
    return out;
  });
}

}  // namespace coilwright::report

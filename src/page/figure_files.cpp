#include "coilwright/page/figure_files.hpp"

#include <cstddef>
#include <stdexcept>
#include <variant>

#include "coilwright/text/markup.hpp"

namespace coilwright::page {
namespace {

// The value of a colour in the first rule of the style, which has the light ones: "#1b2430" of "--ink".
std::string colour_of(std::string_view style, std::string_view name) {
  const std::string key = std::string(name) + ": ";
  const std::size_t start = style.find(key);
  if (start == std::string_view::npos)
    throw std::logic_error("no colour " + std::string(name) + " in the style of pages");
  return std::string(style.substr(start + key.size(), 7));
}

// The rules about drawings, with their colours as they are: few programs beside browsers know colours by name.
std::string drawing_style(std::string_view style) {
  std::string out;
  constexpr std::string_view begin = "svg.pose .";
  for (std::size_t at = style.find(begin); at != std::string_view::npos; at = style.find(begin, at + 1)) {
    std::string rule(style.substr(at, style.find('\n', at) - at));
    for (std::size_t use = rule.find("var("); use != std::string::npos; use = rule.find("var(")) {
      const std::size_t end = rule.find(')', use);
      rule.replace(use, end + 1 - use, colour_of(style, rule.substr(use + 4, end - use - 4)));
    }
    out += rule + "\n";
  }
  return out;
}

std::string with_style(const std::string& svg, std::string_view style) {
  const std::size_t start = svg.find('>') + 1;
  return svg.substr(0, start) + "\n<style>\n" + text::escaped_lines(drawing_style(style)) + "</style>" +
         svg.substr(start);
}

FigureFile file_of(const Figure& figure, std::string_view style) {
  if (const auto* drawing = std::get_if<Drawing>(&figure.content))
    return {.name = figure.id + ".svg", .text = with_style(drawing->svg, style)};
  if (const auto* image = std::get_if<Image>(&figure.content)) return {.name = figure.id + ".svg", .text = image->svg};
  return {.name = figure.id + ".vl.json", .text = std::get<text::Json>(figure.content).text()};
}

}  // namespace

std::vector<FigureFile> figure_files(const Page& page, std::string_view style) {
  std::vector<FigureFile> files;
  for (const Section& section : page.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block)) files.push_back(file_of(*figure, style));
  return files;
}

}  // namespace coilwright::page

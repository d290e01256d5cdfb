#include "coilwright/page/page_html.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <variant>

#include "coilwright/text/markup.hpp"
#include "page/html_parts.hpp"

namespace coilwright::page {
namespace {

using text::escaped;

// What a figure shows: an element that the script fills, or the drawing itself.
std::string picture_html(const Figure& figure) {
  if (const auto* drawing = std::get_if<Drawing>(&figure.content)) return drawing->svg;
  if (const auto* image = std::get_if<Image>(&figure.content))
    return fmt::format(
        "<div class=\"wide\"><img class=\"paper\" src=\"data:image/svg+xml;base64,{}\" alt=\"{}\"></div>\n",
        base64(image->svg), escaped(figure.description));
  return fmt::format("<div class=\"plot\" id=\"{}-plot\" role=\"img\" aria-label=\"{}\"></div>\n", figure.id,
                     escaped(figure.description));
}

struct Writer {
  std::string operator()(const Widget& widget) const { return widget.html; }
  std::string operator()(const auto& block) const { return report::to_html(block); }
  std::string operator()(const Figure& figure) const {
    std::string out = fmt::format("<figure id=\"{}\">\n<h3>{}</h3>\n{}<figcaption>{}</figcaption>\n", figure.id,
                                  escaped(figure.title), picture_html(figure), escaped(figure.description));
    if (!figure.table.rows.empty())
      out += fmt::format("<details><summary>The numbers of this figure ({} rows{})</summary>\n{}</details>\n",
                         figure.table.rows.size(), figure.table.note.empty() ? "" : ", " + escaped(figure.table.note),
                         report::to_html(TableBlock{.caption = figure.title, .table = figure.table}));
    if (const auto* spec = std::get_if<text::Json>(&figure.content))
      out += fmt::format("<script type=\"application/json\" class=\"spec\" data-figure=\"{}\">{}</script>\n", figure.id,
                         text::script_json(spec->text()));
    return out + "</figure>\n";
  }
};

std::string body_of(const Page& page) {
  std::string out =
      fmt::format("<header>\n<h1>{}</h1>\n<p class=\"verdict\">{}</p>\n", escaped(page.title), escaped(page.verdict));
  for (const std::string& caution : page.cautions)
    out += fmt::format("<div class=\"caution\">\n{}</div>\n", report::to_html(Lines{caution}));
  out += fmt::format("<p class=\"origin\">{}</p>\n", escaped(page.origin));
  out += "</header>\n";
  out += "<nav aria-label=\"Sections\"><ul>\n";
  for (const Section& section : page.sections)
    out += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, escaped(section.title));
  out += "</ul></nav>\n";
  // Behind the navigation, which the keyboard reaches first.
  if (!page.inputs.empty()) {
    out += fmt::format("<details class=\"origin\"><summary>The files that it is made of ({})</summary>\n<ul>\n",
                       page.inputs.size());
    for (const std::string& input : page.inputs) out += fmt::format("<li>{}</li>\n", escaped(input));
    out += "</ul></details>\n";
  }
  out += "<noscript><p>The plots need scripts; every table is readable without them.</p></noscript>\n<main>\n";
  for (const Section& section : page.sections) {
    out += fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n<h2 id=\"{0}-title\">{1}</h2>\n",
                       section.id, escaped(section.title));
    for (const Block& block : section.blocks) out += std::visit(Writer{}, block);
    out += "</section>\n";
  }
  out += "</main>\n";
  for (const DataBlock& data : page.data)
    out +=
        fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", data.id, text::script_json(data.json));
  return out;
}

std::string licences_of(const PageAssets& assets) {
  std::string out;
  for (const Script& script : assets.scripts)
    if (!script.licence.empty())
      out += fmt::format("<h3>{}</h3>\n<pre>{}</pre>\n", escaped(script.name), text::escaped_lines(script.licence));
  if (out.empty()) return {};
  return "<footer><details><summary>Licences of the libraries in this page</summary>\n" + out + "</details></footer>\n";
}

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

std::string to_html(const Page& page, const PageAssets& assets, const Digest& digest) {
  const std::string body = body_of(page) + licences_of(assets);
  const std::string nonce = digest(body);
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'nonce-{0}'; style-src "
      "'nonce-{0}'; img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{1}</title>\n<style nonce=\"{0}\">{2}</style>\n"
      "</head>\n<body>\n{3}",
      nonce, escaped(page.title), assets.style, body);
  for (const Script& script : assets.scripts)
    out += fmt::format("<script nonce=\"{}\">{}\n</script>\n", nonce, script.text);
  return out + "</body>\n</html>\n";
}

std::vector<FigureFile> figure_files(const Page& page, std::string_view style) {
  std::vector<FigureFile> files;
  for (const Section& section : page.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block)) files.push_back(file_of(*figure, style));
  return files;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = 0; j < 3; ++j)
      three = three << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j) out += i + j > bytes.size() ? '=' : letters[three >> (18 - 6 * j) & 63U];
  }
  return out;
}

}  // namespace coilwright::page

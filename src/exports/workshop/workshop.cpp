#include "coilwright/exports/kinds.hpp"

#include <fmt/format.h>

#include "coilwright/text/markup.hpp"
#include "exports/cast.hpp"
#include "exports/drawing/sketch.hpp"
#include "exports/packed_files.hpp"
#include "exports/workshop/sheets.hpp"

namespace coilwright::exports {
namespace {

// What fits on a page of A4 beside its text, m.
constexpr double figure_width = 180e-3;
constexpr double figure_height = 185e-3;

std::string figure(const DesignSubject& subject, const BodyPlan& plan) {
  const ScaledSketch scaled = drawing_on(subject, plan, figure_width, figure_height);
  return fmt::format(
      "<figure>\n{}<figcaption>Scale {}, lengths in mm. Slits in red.</figcaption>\n</figure>\n",
      svg_of(scaled.sketch, scaled.scale,
             {.title = "Sections", .description = "Longitudinal section and cross-sections, lengths in mm"}),
      scale_text(scaled.scale));
}

// A complete page for A4 paper, without scripts and without anything from outside. `body` is HTML.
std::string html_page(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      text::escaped(title), text::packed_text(assets(), "workshop.css"), body);
}

}  // namespace

std::vector<ExportedFile> workshop(const DesignSubject& subject, const ExportSettings& settings) {
  const Cast cast = cast_of(subject);
  const WindingSheet winding = winding_sheet(subject, settings);
  const std::vector<BillRow> bill = bill_of_materials(subject, settings, winding, cast);
  const Recipe silicone = recipe(subject, settings, cast);
  const AssemblyOrder order = assembly_order(subject, cast, silicone, winding);
  const std::string title =
      subject.origin.name.empty() ? "Workshop sheets" : fmt::format("Workshop sheets: {}", subject.origin.name);
  const std::string head = fmt::format("<h1>{}</h1>\n<p class=\"from\">{}</p>\n", text::escaped(title),
                                       text::escaped(subject.origin.made_by));
  return {{.name = "workshop.html",
           .text = html_page(title, head + winding_section(winding) + bill_section(bill) + recipe_section(silicone) +
                                        assembly_section(order, figure(subject, cast.plan)))},
          {.name = "winding.csv", .text = winding_csv(winding)},
          {.name = "layers.csv", .text = layers_csv(winding)},
          {.name = "materials.csv", .text = materials_csv(bill)},
          {.name = "casting.csv", .text = casting_csv(silicone)},
          {.name = "assembly.csv", .text = assembly_csv(order)}};
}

}  // namespace coilwright::exports

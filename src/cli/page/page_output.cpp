#include "cli/page/page_output.hpp"

#include <iostream>

#include "cli/outputs.hpp"
#include "cli/page/draw_figures.hpp"
#include "cli/report_option.hpp"
#include "coilwright/page/page_html.hpp"
#include "coilwright/page/pages.hpp"
#include "coilwright/results/page/page_file.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {

void write_page(const page::Page& content, const std::filesystem::path& file, const PageOutput& how) {
  text::OutputFile out(file);
  std::optional<text::OutputFolder> figures;
  if (how.figures) {
    DrawnFigures drawn =
        draw_figures(page::figure_files(content, text::packed_text(results::page_files(), "page.css")));
    figures.emplace(*how.figures);
    for (const page::FigureFile& each : drawn.files) figures->write(each.name, each.text);
    if (!drawn.why.empty()) std::cerr << drawn.why << ".\n";
  }
  out.stream() << results::html_of(content);
  keep_other_kind(out, page_mark, how.force);
  if (figures) {
    keep_others(*figures, how.force);
    out.withdraw();
    figures->commit();
  }
  out.commit();
}

void write_evaluation_page(const simulation::EvaluatedDesign& evaluated, const report::Document& document,
                           const std::string& name, const std::filesystem::path& file, bool force) {
  write_page(page::evaluation_page(evaluated, document, name, results::made_by()), file, {.force = force});
}

}  // namespace coilwright::cli

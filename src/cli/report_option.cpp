#include "report_option.hpp"

#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <string>
#include <string_view>

#include "coilwright/page/page_html.hpp"
#include "coilwright/results/page_file.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "draw_figures.hpp"
#include "options.hpp"
#include "outputs.hpp"

namespace coilwright::cli {

std::string page_name_complaint(const std::string& name) {
  if (name.empty()) return "must not be empty";
  // So that a slip replaces no records and no script.
  return name.ends_with(".html") ? "" : fmt::format("must end in .html; got \"{}\"", name);
}

void add_report_option(CLI::App& command, bool& wanted) {
  add_flag(command, "--report", wanted, fmt::format("Write a page to look at as well: {} in that folder", report_name))
      ->check([](const std::string&) { return results::why_no_page(); });
}

void add_report_file_option(CLI::App& command, std::optional<std::string>& file, bool& force) {
  add_force_option(command, force);
  command.add_option("--report", file, "HTML file for a page to look at and to pass on, that works without a network")
      ->check([](const std::string& name) {
        if (name == "-") return std::string("must be a file: standard output has the answer itself");
        const std::string complaint = page_name_complaint(name);
        return complaint.empty() ? results::why_no_page() : complaint;
      });
}

void write_report(const std::filesystem::path& folder, const std::filesystem::path& file,
                  const ReportOptions& options) {
  write_page(results::page_of_folder(folder, options.pictures), file, options);
}

void write_page(const page::Page& content, const std::filesystem::path& file, const ReportOptions& options) {
  text::OutputFile out(file);
  std::optional<text::OutputFolder> figures;
  if (options.figures) {
    DrawnFigures drawn =
        draw_figures(page::figure_files(content, text::packed_text(results::page_files(), "page.css")));
    figures.emplace(*options.figures);
    for (const page::FigureFile& each : drawn.files) figures->write(each.name, each.text);
    if (!drawn.why.empty()) std::cerr << drawn.why << ".\n";
  }
  out.stream() << results::html_of(content);
  keep_other_kind(out, page_mark, options.force);
  if (figures) {
    keep_others(*figures, options.force);
    out.withdraw();
    figures->commit();
  }
  out.commit();
}

}  // namespace coilwright::cli

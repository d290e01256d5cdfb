#include "coilwright/video/tag_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "coilwright/video/tag_pattern.hpp"

namespace coilwright::video {
namespace {

constexpr double page_width = 210.0;   // mm
constexpr double page_height = 297.0;  // mm
constexpr double margin = 15.0;        // mm
constexpr double points_a_mm = 72.0 / 25.4;

// The content of a page; mm from its left top corner.
class Page {
 public:
  void black(double x, double y, double width, double height) {
    add("{:.4f} {:.4f} {:.4f} {:.4f} re f\n", x, y + height, width, height);
  }
  // A line to cut along.
  void frame(double x, double y, double width, double height) {
    content_ += "0.2 w 0.6 G ";
    add("{:.4f} {:.4f} {:.4f} {:.4f} re S\n", x, y + height, width, height);
  }
  void text(double x, double y, std::string_view words) {
    fmt::format_to(std::back_inserter(content_), "BT /F1 9 Tf {:.4f} {:.4f} Td ({}) Tj ET\n", x * points_a_mm,
                   (page_height - y) * points_a_mm, words);
  }
  [[nodiscard]] const std::string& content() const noexcept { return content_; }

 private:
  void add(fmt::format_string<double, double, double, double> form, double x, double bottom, double width,
           double height) {
    fmt::format_to(std::back_inserter(content_), form, x * points_a_mm, (page_height - bottom) * points_a_mm,
                   width * points_a_mm, height * points_a_mm);
  }
  std::string content_;
};

// The white margin of a module is inside of the frame.
void draw_tag(Page& page, int tag, double x, double y, double module) {
  page.frame(x, y, (tag_modules + 2) * module, (tag_modules + 2) * module);
  for (int row = 0; row < tag_modules; ++row) {
    int column = 0;
    while (column < tag_modules) {
      int end = column;
      while (end < tag_modules && !is_white(tag, row, end)) ++end;
      // A hair longer downwards: between two rectangles that touch, viewers show a white line.
      if (end > column) {
        const double more = row + 1 < tag_modules ? 0.01 : 0.0;
        page.black(x + (column + 1) * module, y + (row + 1) * module, (end - column) * module, module + more);
      }
      column = std::max(end, column + 1);
    }
  }
}

void draw_ruler(Page& page, double y) {
  constexpr int length = 100;  // mm
  page.black(margin, y, length, 0.2);
  for (int mm = 0; mm <= length; ++mm)
    page.black(margin + mm - 0.1, y, 0.2, mm % 10 == 0 ? 5.0 : (mm % 5 == 0 ? 3.5 : 2.0));
  page.text(margin, y + 9.0, "This ruler must be 100 mm long. If it is not, print at 100 % \\(no fit to page\\).");
}

Page tag_page(double size) {
  Page page;
  page.text(margin, margin,
            fmt::format("Tags of {:.4g} mm for coilwright track. Cut along the grey lines, glue flat,", size));
  page.text(margin, margin + 4.5,
            "upright as the words are when the finger hangs down: 0 to the base, 1 to the first segment, and so on.");
  draw_ruler(page, margin + 9.0);
  const double module = size / tag_modules;
  const double side = (tag_modules + 2) * module;
  double y = margin + 28.0;
  for (int tag = 0; tag < tag_count && y + side < page_height - margin; ++tag, y += side + 8.0) {
    page.text(margin, y - 1.5, tag == 0 ? "0, base" : fmt::format("{}, segment {}", tag, tag));
    for (double x = margin; x + side < page_width - margin; x += side + 3.0) draw_tag(page, tag, x, y, module);
  }
  return page;
}

Page board_page() {
  Page page;
  page.text(margin, margin,
            "Board for coilwright lens: glue it to a flat plate, and film it from all sides, near and far.");
  constexpr double square = board_square * 1e3;
  const double left = 0.5 * (page_width - (board_columns + 1) * square);
  for (int row = 0; row <= board_rows; ++row)
    for (int column = row % 2; column <= board_columns; column += 2)
      page.black(left + column * square, 2.0 * margin + row * square, square, square);
  return page;
}

std::string pdf(const std::vector<Page>& pages) {
  const std::size_t first_page = 4;  // after catalogue, list of pages and font; each page is followed by its content
  std::string kids;
  for (std::size_t i = 0; i < pages.size(); ++i) kids += fmt::format("{} 0 R ", first_page + 2 * i);
  std::vector<std::string> objects{"<< /Type /Catalog /Pages 2 0 R >>",
                                   fmt::format("<< /Type /Pages /Kids [{}] /Count {} /MediaBox [0 0 {:.3f} {:.3f}] >>",
                                               kids, pages.size(), page_width * points_a_mm, page_height * points_a_mm),
                                   "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"};
  for (const Page& page : pages) {
    objects.push_back(fmt::format(
        "<< /Type /Page /Parent 2 0 R /Resources << /Font << /F1 3 0 R >> >> /Contents {} 0 R >>", objects.size() + 2));
    objects.push_back(fmt::format("<< /Length {} >>\nstream\n{}endstream", page.content().size(), page.content()));
  }
  std::string out = "%PDF-1.4\n";
  std::string places = "0000000000 65535 f \n";
  for (std::size_t i = 0; i < objects.size(); ++i) {
    places += fmt::format("{:010} 00000 n \n", out.size());
    out += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
  }
  const std::size_t table = out.size();
  return out + fmt::format("xref\n0 {}\n{}trailer\n<< /Size {} /Root 1 0 R >>\nstartxref\n{}\n%%EOF\n",
                           objects.size() + 1, places, objects.size() + 1, table);
}

}  // namespace

std::string tag_sheet(double tag_size) {
  return pdf({tag_page(tag_size * 1e3), board_page()});
}

}  // namespace coilwright::video

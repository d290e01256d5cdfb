#include "page/summary_text.hpp"

#include <algorithm>
#include <sstream>

#include "coilwright/text/input_text.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::page {

std::vector<std::string> summary_lines(const std::filesystem::path& folder, std::string_view heading) {
  const std::filesystem::path file = folder / "summary.txt";
  if (!std::filesystem::is_regular_file(file)) return {};
  std::istringstream lines(text::read_text(file, text::json_size_limit).text);
  std::string line;
  while (std::getline(lines, line) && !heading.empty() && line != heading) {
  }
  std::vector<std::string> out;
  while (std::getline(lines, line)) {
    if (line.empty() && !out.empty()) break;
    if (!line.empty()) out.push_back(line.substr(std::min(line.find_first_not_of(' '), line.size())));
  }
  return out;
}

}  // namespace coilwright::page

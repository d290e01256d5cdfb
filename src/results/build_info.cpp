#include "coilwright/results/build_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace coilwright::results {

std::string version() {
  return COILWRIGHT_VERSION;
}

std::vector<Library> libraries() {
  // CMake finds them, and knows their versions: "NLopt=2.7.1,Ceres=2.1.0,..."
  std::vector<Library> found;
  std::string_view rest = COILWRIGHT_LIBRARIES;
  while (!rest.empty()) {
    const std::string_view row = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), row.size() + 1));
    const std::size_t equals = row.find('=');
    found.push_back({.name = std::string(row.substr(0, equals)), .version = std::string(row.substr(equals + 1))});
  }
  return found;
}

std::string compiler() {
  return COILWRIGHT_COMPILER;
}

std::string why_no_page() {
  if (COILWRIGHT_DRAWS_PAGES) return {};
  return "this program was built without Vega, which pages are drawn with: install npm and build it again "
         "(cmake -DCOILWRIGHT_REPORT_ASSETS=ON says what is missing)";
}

std::string version_text() {
  const Commit built = commit();
  std::string text = fmt::format("coilwright {}\n", version());
  if (built.hash.empty()) {
    text += "Commit unknown: built outside of its git repository.\n";
  } else {
    text += fmt::format("Commit {}{}.\n", built.hash, built.changed ? ", changed since" : "");
  }
  text += fmt::format("Built by {} with", compiler());
  std::string_view separator = " ";
  for (const Library& library : libraries()) {
    text += fmt::format("{}{} {}", separator, library.name, library.version);
    separator = ", ";
  }
  return text + ".";
}

text::Json version_json() {
  using text::Json;
  const Commit built = commit();
  Json list = Json::object({});
  for (const Library& library : libraries()) list.set(library.name, library.version);
  return Json::object({{"program", "coilwright"},
                       {"version", version()},
                       {"commit", text::text_or_null(built.hash)},
                       {"changed_since_commit", built.hash.empty() ? Json(nullptr) : Json(built.changed)},
                       {"compiler", compiler()},
                       {"libraries", list}});
}

}  // namespace coilwright::results

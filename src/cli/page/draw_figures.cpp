#include "cli/page/draw_figures.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "coilwright/results/page/page_file.hpp"
#include "coilwright/text/input_text.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/packed_file.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;

// A folder of this run alone, gone with it.
class WorkFolder {
 public:
  WorkFolder() {
    std::string pattern = (fs::temp_directory_path() / "coilwright-XXXXXX").string();
    if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~WorkFolder() {
    std::error_code none;
    if (!path_.empty()) fs::remove_all(path_, none);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void write(const fs::path& file, std::string_view text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

// Its exit status; -1 where it could not be started.
int run_node(const fs::path& script, const fs::path& folder) {
  std::string first = "node";
  std::string second = script.string();
  std::string third = folder.string();
  const std::array<char*, 4> arguments{first.data(), second.data(), third.data(), nullptr};
  pid_t child{};
  if (posix_spawnp(&child, "node", nullptr, nullptr, arguments.data(), environ) != 0) return -1;
  int status{};
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

}  // namespace

DrawnFigures draw_figures(std::vector<page::FigureFile> files) {
  constexpr std::string_view chart = ".vl.json";
  const WorkFolder work;
  if (work.path().empty()) return {.files = std::move(files), .why = "no folder for temporary files could be made"};
  const fs::path charts = work.path() / "charts";
  fs::create_directories(charts);
  for (const char* name : {"figures.cjs", "theme.js", "page.css"})
    write(work.path() / name, text::packed_text(results::page_files(), name));
  write(work.path() / "node_modules/vega/index.js", text::packed_text(results::report_libraries(), "vega.js"));
  write(work.path() / "node_modules/vega-lite/index.js",
        text::packed_text(results::report_libraries(), "vega-lite.js"));
  for (const page::FigureFile& file : files)
    if (file.name.ends_with(chart)) write(charts / file.name, file.text);
  const int status = run_node(work.path() / "figures.cjs", charts);
  if (status == -1 || status == 127)
    return {.files = std::move(files),
            .why = "Node (node) is not installed, which draws the charts: they stand as Vega-Lite in NAME.vl.json"};
  if (status != 0)
    return {.files = std::move(files),
            .why = "Node could not draw the charts: they stand as Vega-Lite in NAME.vl.json"};
  DrawnFigures out{.files = std::move(files), .why = {}};
  for (std::size_t i = 0, count = out.files.size(); i < count; ++i) {
    if (!out.files[i].name.ends_with(chart)) continue;
    const std::string name = out.files[i].name.substr(0, out.files[i].name.size() - chart.size()) + ".svg";
    out.files.push_back({.name = name, .text = text::read_text(charts / name, text::json_size_limit).text});
  }
  return out;
}

}  // namespace coilwright::cli

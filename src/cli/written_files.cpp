#include "written_files.hpp"

namespace coilwright::cli {

void add_written_json_option(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "Print what was written as JSON")->disable_flag_override();
}

text::Json written_json(std::span<const std::filesystem::path> files) {
  text::Json names = text::Json::array();
  for (const std::filesystem::path& each : files) names.add(each.string());
  return text::Json::object({{"files", std::move(names)}});
}

void require_file_for_json(bool json, const std::string& out) {
  if (json && out == "-")
    throw CLI::ValidationError("--json", "needs a file for --out: standard output has the result itself");
}

}  // namespace coilwright::cli

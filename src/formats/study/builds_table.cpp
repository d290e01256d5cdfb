#include <fmt/format.h>

#include <ostream>
#include <string_view>

#include "coilwright/formats/study/part_file.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "coilwright/text/csv/csv_writer.hpp"

namespace coilwright::formats {
namespace {

constexpr std::size_t columns_before_values = 2;

}  // namespace

void write_builds(std::ostream& out, std::span<const sizing::Build> builds) {
  std::vector<std::string> columns{"has_performance", "failure"};
  for (std::size_t i = 0; !builds.empty() && i < builds.front().values.size(); ++i)
    columns.push_back(fmt::format("value{}", i + 1));
  text::CsvWriter csv(out, columns);
  for (const sizing::Build& build : builds) {
    std::vector<text::CsvCell> row{build.has_performance ? 1 : 0, build.failure};
    for (const std::optional<double>& value : build.values) row.emplace_back(value);
    csv.row(row);
  }
}

void read_builds(const std::filesystem::path& table, std::vector<sizing::Build>& builds) {
  text::for_each_csv_row(
      table, [](std::string_view) { return true; },
      [&](std::span<const std::string_view> fields, std::size_t line) {
        sizing::Build& build = builds.emplace_back();
        build.has_performance = fields[0] == "1";
        build.failure = fields[1];
        for (const std::string_view field : fields.subspan(columns_before_values))
          build.values.push_back(text::number_or_nothing(field, table.string(), line, "value"));
      });
}

}  // namespace coilwright::formats

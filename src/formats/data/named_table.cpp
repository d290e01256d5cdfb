#include "formats/data/named_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>

#include "coilwright/text/csv/csv_form.hpp"
#include "coilwright/text/number.hpp"

namespace coilwright::formats {
namespace {

namespace fs = std::filesystem;

bool is_inside(const fs::path& file, const fs::path& folder) {
  std::error_code none;
  const fs::path outer = fs::canonical(folder.empty() ? "." : folder, none);
  const fs::path inner = fs::weakly_canonical(file, none);
  return std::ranges::mismatch(outer, inner).in1 == outer.end();
}

// By itself, whatever the document says of its separator; with decimal points or commas.
bool is_table_of_numbers(const fs::path& file) {
  std::size_t numbers = 0;
  std::size_t fields = 0;
  try {
    for (const auto& row : text::read_csv_form(file).sample)
      for (std::string field : row) {
        std::ranges::replace(field, ',', '.');
        ++fields;
        numbers += text::number_in(field) ? 1 : 0;
      }
  } catch (const text::InputError&) {
    return false;
  }
  return numbers > 0 && 2 * numbers >= fields;
}

}  // namespace

bool may_show(const text::InputError& error, const std::string& document) {
  const text::Fault& fault = error.fault();
  const bool is_of_the_whole = fault.place.empty() && fault.value.empty();
  return is_of_the_whole || is_inside(fault.file, fs::path(document).parent_path()) || is_table_of_numbers(fault.file);
}

text::InputError without_findings(const text::InputError& error, const std::string& document) {
  return text::InputError(
      {.file = error.fault().file,
       .rule =
           fmt::format("must be a table of numbers with a line of names; what stands in it is not shown, as it lies "
                       "outside of the folder of {}",
                       document)});
}

}  // namespace coilwright::formats

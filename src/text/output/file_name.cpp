#include "coilwright/text/output/file_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "coilwright/text/one_line.hpp"

namespace coilwright::text {
namespace {

std::string without_capitals(std::string name) {
  std::ranges::transform(name, name.begin(), [](char each) {
    return each >= 'A' && each <= 'Z' ? static_cast<char>(each - 'A' + 'a') : each;
  });
  return name;
}

}  // namespace

std::optional<std::string> fault_of_file_name(std::string_view name) {
  constexpr std::size_t longest = 255;  // bytes, of any file system in use
  if (name.empty() || name == "." || name == ".." || name.find_first_of("/\\") != std::string_view::npos)
    return "must be a plain file name";
  if (one_line(name, name.size()) != name) return "must be one line without control characters";
  if (name.size() > longest) return fmt::format("must have at most {} bytes", longest);
  return std::nullopt;
}

std::optional<FileNameFault> fault_of_file_names(std::span<const std::string> names) {
  std::map<std::string, std::string_view> met;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (const auto rule = fault_of_file_name(names[i])) return FileNameFault{.index = i, .rule = *rule};
    const auto [place, is_new] = met.try_emplace(without_capitals(names[i]), names[i]);
    if (is_new) continue;
    if (place->second == names[i]) return FileNameFault{.index = i, .rule = "must not be there twice"};
    return FileNameFault{.index = i,
                         .rule = fmt::format("must differ from {} by more than capitals: on many systems they are one "
                                             "file",
                                             in_quotes(place->second))};
  }
  return std::nullopt;
}

}  // namespace coilwright::text

#pragma once

#include <iostream>
#include <ostream>
#include <string_view>

namespace coilwright::cli {

/// Where a command tells of its results: standard output or, where "-" puts one of its files there, standard error.
[[nodiscard]] inline std::ostream& report_stream(std::string_view file, std::string_view another_file = {}) {
  return file == "-" || another_file == "-" ? std::cerr : std::cout;
}

}  // namespace coilwright::cli

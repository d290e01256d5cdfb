#include "truth/text_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace truth {

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace truth

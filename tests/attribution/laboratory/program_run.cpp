#include "attribution/laboratory/program_run.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace attribution::laboratory {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::string words_of(const std::string& command, const std::filesystem::path& words) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): no signal is handled here
  const int status = std::system(fmt::format("({}) > '{}' 2>&1", command, words.string()).c_str());
  std::string text = text_of(words);
  if (status != 0) throw std::runtime_error(text);
  return text;
}

}  // namespace attribution::laboratory

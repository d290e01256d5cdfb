#include "attribution/laboratory/run_case.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "attribution/laboratory/score.hpp"
#include "attribution/temporary_set_folder.hpp"
#include "truth/laboratory/laboratory_set.hpp"

namespace attribution::laboratory {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

Outcome run_case(const Case& asked, const std::filesystem::path& program, int threads) {
  const TemporarySetFolder folder("laboratory", asked.number);
  const truth::laboratory::LaboratorySet set = truth::laboratory::make_laboratory_set(asked.request);
  truth::laboratory::write_laboratory_set(set, folder.path() / "set");
  const std::filesystem::path out = folder.path() / "out";
  const std::filesystem::path words = folder.path() / "words.txt";
  const std::string command =
      fmt::format("'{}' diagnose '{}' --out '{}' --threads {} --quiet > '{}' 2>&1", program.string(),
                  (folder.path() / "set").string(), out.string(), threads, words.string());
  const auto begin = std::chrono::steady_clock::now();
  const int status = std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe): no signal is handled here
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (status != 0) throw std::runtime_error(fmt::format("set {}: {}", asked.number, text_of(words)));
  Outcome outcome = score(asked, set, text_of(out / "diagnosis.json"));
  outcome.seconds = seconds;
  return outcome;
}

}  // namespace attribution::laboratory

#include "attribution/laboratory/run_case.hpp"

#include <fmt/format.h>

#include <chrono>

#include "attribution/laboratory/program_run.hpp"
#include "attribution/laboratory/score.hpp"
#include "attribution/temporary_set_folder.hpp"
#include "truth/laboratory/laboratory_set.hpp"

namespace attribution::laboratory {
Outcome run_case(const Case& asked, const std::filesystem::path& program, int threads) {
  const TemporarySetFolder folder("laboratory", asked.number);
  const truth::laboratory::LaboratorySet set = truth::laboratory::make_laboratory_set(asked.request);
  truth::laboratory::write_laboratory_set(set, folder.path() / "set");
  const std::filesystem::path out = folder.path() / "out";
  const auto begin = std::chrono::steady_clock::now();
  (void)words_of(fmt::format("'{}' diagnose '{}' --out '{}' --threads {} --quiet", program.string(),
                             (folder.path() / "set").string(), out.string(), threads),
                 folder.path() / "words.txt");
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  Outcome outcome = score(asked, set, text_of(out / "diagnosis.json"));
  outcome.seconds = seconds;
  return outcome;
}

}  // namespace attribution::laboratory

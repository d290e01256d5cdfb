#include "attribution/run_case.hpp"

#include <chrono>
#include <filesystem>

#include "attribution/temporary_set_folder.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "truth/data_set.hpp"

namespace attribution {
namespace {

namespace formats = coilwright::formats;
namespace measurement = coilwright::measurement;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

measurement::Diagnosis diagnose(const std::filesystem::path& folder, int threads) {
  const formats::DatasetFile set = formats::read_dataset(folder);
  const formats::DeclaredActuator declared = formats::read_declared_actuator(
      set.actuator.value(), {.names = set.calibrate, .file = set.file, .tolerances = set.tolerances});
  return measurement::diagnose(set.data, declared.model, {.threads = threads});
}

}  // namespace

CaseRun run_case(const Case& asked, int threads) {
  const TemporarySetFolder folder("attribution", asked.number);
  const auto begin = std::chrono::steady_clock::now();
  const truth::DataSet set = truth::make_data_set(asked.request);
  truth::write_data_set(set, folder.path());
  const double made = seconds_since(begin);
  const auto written = std::chrono::steady_clock::now();
  const measurement::Diagnosis diagnosis = diagnose(folder.path(), threads);
  return {.outcome = score(asked, set.answer, diagnosis),
          .seconds_made = made,
          .seconds_diagnosed = seconds_since(written),
          .phases = diagnosis.phases};
}

}  // namespace attribution

#include "attribution/run_case.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "truth/data_set.hpp"

namespace attribution {
namespace {

namespace formats = coilwright::formats;
namespace measurement = coilwright::measurement;

// A temporary folder that is removed in any case.
class Folder {
 public:
  explicit Folder(int number)
      : path_(std::filesystem::temp_directory_path() / fmt::format("coilwright_attribution_{}_{}", getpid(), number)) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

measurement::Diagnosis diagnose(const std::filesystem::path& folder, int threads) {
  const formats::DatasetFile set = formats::read_dataset(folder);
  const formats::DeclaredActuator declared =
      formats::read_declared_actuator(set.actuator.value(), {.names = set.calibrate, .file = set.file});
  return measurement::diagnose(set.data, declared.model, {.threads = threads});
}

}  // namespace

CaseRun run_case(const Case& asked, int threads) {
  const Folder folder(asked.number);
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

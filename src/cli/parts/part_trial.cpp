#include "cli/parts/part_trial.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/programs.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

constexpr std::chrono::seconds longest_trial(3);

// It goes with the trial.
class TrialFolder {
 public:
  TrialFolder() {
    const std::filesystem::path above = std::filesystem::temp_directory_path();
    std::string name = (above / "coilwright-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error(
          fmt::format("{} takes no folder: {}", above.string(), std::generic_category().message(errno)));
    path_ = name;
  }
  ~TrialFolder() {
    std::error_code stays;
    std::filesystem::remove_all(path_, stays);
  }
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

void require_part_runs(const std::vector<std::string>& arguments,
                       const std::function<void(text::OutputFolder&)>& fill) {
  const TrialFolder trial;
  text::OutputFolder folder(trial.path());
  fill(folder);
  folder.commit("head.json");
  const auto failure = failure_within(longest_trial, trial.path(), arguments);
  if (!failure) return;
  constexpr const char* place = "no part can run";
  if (failure->code == static_cast<int>(ExitCode::bad_input))
    throw text::InputError({.file = place, .rule = failure->line});
  throw std::runtime_error(fmt::format("{}: {}", place, failure->line));
}

}  // namespace coilwright::cli

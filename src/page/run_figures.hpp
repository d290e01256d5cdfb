#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "coilwright/page/page.hpp"

namespace coilwright::page {

/// One channel of one run in residuals.csv.
struct RunRecord {
  std::string run;      ///< "step_1.4A.csv"
  std::string role;     ///< "fit", "validate"
  std::string channel;  ///< "bending_angle_deg"
  std::string axis;     ///< "time_s", "angle_deg" or "current_A"
  std::vector<double> x{};
  std::vector<double> measured{};
  std::size_t outliers = 0;  ///< samples that were left out of fits and errors
  struct Prediction {
    std::string name;  ///< "as declared"
    std::vector<double> x{};
    std::vector<double> y{};
    std::vector<double> residual{};  ///< measured less predicted; of outliers straight between their neighbours
  };
  std::vector<Prediction> predictions{};  ///< those that have any value
};

/// residuals.csv of a folder, in its order.
[[nodiscard]] std::vector<RunRecord> read_runs(const std::filesystem::path& folder);

/// Of each run what was measured and what each model predicts, and what is left over; and, of what each model leaves
/// over in a run over time, the spectrum. `number` makes the ids unique.
[[nodiscard]] std::vector<Figure> run_figures(const RunRecord& record, std::size_t number);

/// Amplitude of each line of an even record's spectrum, its mean taken off.
struct Spectrum {
  std::vector<double> frequencies;  ///< Hz, from the first line to half the sampling rate
  std::vector<double> amplitudes;   ///< of a sine at that line, in the unit of the values
};

/// Of at least eight values every `interval` s; empty for fewer. A sine of amplitude a that fits the record has a at
/// its line.
[[nodiscard]] Spectrum spectrum_of(const std::vector<double>& values, double interval);

/// Of a long record an even choice of samples that a picture can show: at most 1200.
class Thinning {
 public:
  explicit Thinning(std::size_t count);
  [[nodiscard]] std::vector<double> of(const std::vector<double>& values) const;
  /// " One sample in 4 is drawn."; empty where all are.
  [[nodiscard]] std::string text() const;

 private:
  std::size_t stride_;
};

}  // namespace coilwright::page

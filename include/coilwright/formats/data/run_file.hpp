#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/data/run.hpp"
#include "coilwright/text/csv/csv_form.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::formats {

/// The layout of a file, and the parts of it that the file must have.
struct FileLayout {
  text::CsvLayout layout{};
  /// Names and "sampling_rate_Hz" for which the file must have a use, with the key that states them: {"frame",
  /// "ignore"}.
  std::map<std::string, std::string> must_fit{};
};

/// The entry of a run in a data set, beside its CSV file.
struct RunEntry {
  std::string name{};  ///< the file, as the data set calls it
  measurement::data::RunKind kind{};
  measurement::data::Start start{};
  std::optional<double> window{};  ///< s
  /// Standard deviation in the unit of the run's measured column. In a transient with several columns it is that of the
  /// first angle (the bending angle comes before those of the joints), or of the first rate if there are only rates.
  std::optional<double> sigma{};
  FileLayout layout{};                                ///< of its file
  std::optional<std::filesystem::path> input_file{};  ///< of a transient: its input, on a clock of its own
  std::optional<FileLayout> input_layout{};  ///< layout of the input file; absent: that of the run's file and of what
                                             ///< must fit must fit one of the two
  measurement::data::InputHold hold{};
  measurement::data::RigChange rig{};
  std::optional<double> clock_offset{};  ///< s, standard deviation of the shift of the clocks, >= 0; absent: 0 in one
                                         ///< file, with an `input_file` the median interval between measured samples
  double clock_rate{};                   ///< standard deviation of the relative difference of the clocks' rates; >= 0
  double exposure{};                     ///< s; >= 0
  /// Error of a transient's input, in the unit of its first column; one number for all columns or one each.
  measurement::data::InputUncertainty input_uncertainty{};
};

/// Why a run cannot be used although its file is well formed, such as an angle that no finger reaches. The reader does
/// not throw it, because a run that is held out must not be examined.
struct Objection {
  text::InputError error;
  std::optional<text::CsvColumn> wrapped{};  ///< the column that states that a reading wraps
};

/// The content of a run's file.
struct RunFile {
  measurement::data::Run run;
  std::optional<Objection> objection{};
  std::vector<measurement::data::Warning> warnings{};  ///< remarks on irregular rows
  std::set<std::string> used{};                        ///< names in its layouts that its files use
};

/// Reads the CSV file of a run, and that of its input if that is another file, as their layouts say. A row of a
/// transient may lack the input, or all measured values; the input then has times of its own.
///
/// Columns by kind (units of one dimension are interchangeable):
/// - transient: time_s, one input (current_A; current1_A, ..; voltage_V; torque1_Nm, ..), at least one of
///   bending_angle_deg, theta1_deg, .., omega1_rad_s, ..; the input may be left out if the coils are open or shorted,
///   and is then a current of 0 in all of them;
/// - still: time_s and the same measured columns; an input is ignored;
/// - static_torque: angle_deg, current_A, torque_Nmm;
/// - joint_stiffness: angle_deg, torque_Nmm;
/// - blocked_force: current_A, force_N, and optionally opening_deg and height_mm;
/// - temperature: time_s, current_A, temperature_degC.
///
/// Throws InputError naming file, line, column and rule, with the columns to write into dataset.json if names differ;
/// also if a column is in both files, or if the input does not cover the measurement: it must not begin later by more
/// than three of the clocks' standard deviations, and not end earlier by more than those and the longest interval
/// between two of its own samples.
[[nodiscard]] RunFile read_run(const std::filesystem::path& path, const RunEntry& entry);

/// Parses a run from a text in memory; errors call it `file`.
[[nodiscard]] RunFile parse_run(std::string_view text, std::string file, const RunEntry& entry);

}  // namespace coilwright::formats

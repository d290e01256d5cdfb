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

/// The layout of a file, and what of it the file must have.
struct FileLayout {
  text::CsvLayout layout{};
  /// Sources and "sampling_rate_Hz" that the file must have a use for, with the key that has them: {"frame", "ignore"}.
  std::map<std::string, std::string> must_fit{};
};

/// What a data set says of a run beside its CSV file.
struct RunEntry {
  std::string name{};  ///< the file, as the data set calls it
  measurement::data::RunKind kind{};
  measurement::data::Start start{};
  std::optional<double> window{};  ///< s
  /// In the unit of the run's measured column; where a transient has several: of its first angle column (that of the
  /// bending angle before those of the joints), and where it has rates only, of its first rate.
  std::optional<double> sigma{};
  FileLayout layout{};                                ///< of its file
  std::optional<std::filesystem::path> input_file{};  ///< of a transient: its input, on a clock of its own
  std::optional<FileLayout> input_layout{};           ///< of that; nothing: as of the run's file, and what must fit
                                                      ///< must fit one of the two
  measurement::data::InputHold hold{};
  measurement::data::RigChange rig{};
  std::optional<double> clock_offset{};  ///< s, standard deviation of the shift of the clocks, >= 0; nothing: 0 in one
                                         ///< file, with an `input_file` the median interval between measured samples
  double clock_rate{};                   ///< standard deviation of the relative difference of the clocks' rates; >= 0
  double exposure{};                     ///< s; >= 0
  /// Of a transient's input; in the unit of its first column, one number for all columns or one each.
  measurement::data::InputUncertainty input_uncertainty{};
};

/// Why a run cannot be used though its file is well formed: an angle that no finger reaches. Not thrown by the reader,
/// because a run that is held out is not to be looked at.
struct Objection {
  text::InputError error;
  std::optional<text::CsvColumn> wrapped{};  ///< where a reading wraps: the column that says so
};

/// A run as its file gives it.
struct RunFile {
  measurement::data::Run run;
  std::optional<Objection> objection{};
  std::vector<measurement::data::Warning> warnings{};  ///< how its rows were taken, where that is not plain
  std::set<std::string> used{};                        ///< what of its layouts its files have a use for
};

/// Reads the CSV file of a run, and the file of its input if that is another, as their layouts say. A row of a
/// transient may lack the input, or all measured values: the input has then times of its own. Columns by kind (units of
/// one dimension are interchangeable): transient: time_s, one input (current_A; current1_A, ..; voltage_V; torque1_Nm,
/// ..), at least one of bending_angle_deg, theta1_deg, .., omega1_rad_s, ..; the input may be left out where the coils
/// are open or shorted, and is then a current of 0 in all of them; still: time_s and the same measured columns; an
/// input is not looked at; static_torque: angle_deg, current_A, torque_Nmm; joint_stiffness: angle_deg, torque_Nmm;
/// blocked_force: current_A, force_N, and opening_deg and height_mm if that was changed; temperature: time_s,
/// current_A, temperature_degC.
/// Throws InputError naming file, line, column and rule, with the columns to write into dataset.json where names are
/// others; also where a column is in both files, or where the input does
/// not cover the measurement: it must not begin later by more than three of the clocks' standard deviations, and not
/// end earlier by more than those and the longest interval between two of its own samples.
[[nodiscard]] RunFile read_run(const std::filesystem::path& path, const RunEntry& entry);

/// The same for a text in memory; `file` is the name its errors carry.
[[nodiscard]] RunFile parse_run(std::string_view text, std::string file, const RunEntry& entry);

}  // namespace coilwright::formats

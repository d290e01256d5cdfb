#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace coilwright::text {

/// A column of a table of another program that stands for one of ours.
struct CsvColumn {
  std::string source{};  ///< name in the file, or "#4" for the fourth
  std::string name{};    ///< ours, with a unit: "current_mA"
  double factor{1.0};    ///< finite, not 0: the value is factor times the number in the file, plus offset
  double offset{0.0};    ///< in the unit of `name`
  double period{0.0};    ///< in the unit of `name`, > 0: readings jump by this and are put together, the first one to
                         ///< within half of it about 0; 0: they do not
};

/// A point of a picture: two columns, each by name or position, or a fixed place in the unit of the positions.
using CsvPoint = std::variant<std::array<std::string, 2>, std::array<double, 2>>;

/// An angle from positions: that of a line from straight down, or from the line `against`, positive towards +x.
struct CsvMarkers {
  std::string name{};              ///< ours: "bending_angle_deg"
  std::array<CsvPoint, 2> line{};  ///< from, to
  std::optional<std::array<CsvPoint, 2>> against{};
  bool y_is_up{false};
  double factor{1.0};  ///< as in CsvColumn
  double offset{0.0};
};

/// The layout of a table as far as it is stated; absent values are found in the file.
struct CsvLayout {
  std::size_t skip_lines{0};              ///< lines that are skipped; the names follow below
  std::optional<char> separator{};        ///< ' ': any number of blanks
  std::optional<char> decimal{};          ///< '.' or ','
  std::vector<CsvColumn> columns{};       ///< columns; sources that the file does not have are ignored
  std::vector<CsvMarkers> markers{};      ///< markers; sources that the file does not have are ignored
  std::vector<std::string> ignore{};      ///< names or positions of columns left alone, also where `columns` has them
  bool ignore_others{false};              ///< whether columns that nobody names or knows are left alone
  std::optional<double> sampling_rate{};  ///< Hz, > 0; of a file without a column of time
};

/// The position that "#4" names, from 0; absent if the text is a name.
[[nodiscard]] std::optional<std::size_t> position_in(std::string_view source) noexcept;

/// Positions of the names and the numbers in a table, found in its first quarter of a megabyte.
struct CsvForm {
  char separator{','};
  char decimal{'.'};
  bool arrows{false};                   ///< whether rows begin with "10:11:32.002 -> ", as a terminal writes it
  std::vector<std::string> preamble{};  ///< lines above the names, as they are
  std::vector<std::string> names{};     ///< of the columns, in UTF-8; "" where one has none
  std::size_t names_line{0};            ///< from 1; 0: no line has the names
  std::size_t rows_line{0};             ///< of the first row of numbers; 0: there is none
  std::size_t rows_at{0};               ///< the byte at which it begins
  std::vector<std::vector<std::string>> sample{};  ///< fields of the first rows, of a table of numbers

  /// Whether a column is empty in every row of the sample.
  [[nodiscard]] bool is_empty(std::size_t column) const;
};

/// Finds the form of a text. `whole` tells whether the text is all of the file. A separator or decimal sign in `layout`
/// is used, and its skipped lines are ignored. Throws InputError for a text that is not UTF-8 or Latin-1, has no line
/// to read, or has numbers with commas that can mean two things.
[[nodiscard]] CsvForm find_csv_form(std::string_view text, bool whole, const std::string& file,
                                    const CsvLayout& layout);

/// Finds the form of a file. Throws InputError also if it cannot be read.
[[nodiscard]] CsvForm read_csv_form(const std::filesystem::path& path, const CsvLayout& layout = {});

/// Number of bytes at the front of a file from which its form is found.
inline constexpr std::size_t csv_form_size = 1 << 18;

}  // namespace coilwright::text

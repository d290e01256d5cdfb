#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace coilwright::text {

/// A column of somebody's table that is one of ours.
struct CsvColumn {
  std::string source{};  ///< its name in the file, or "#4": the fourth
  std::string name{};    ///< ours, with a unit: "current_mA"
  double factor{1.0};    ///< finite, not 0: the value is factor times the number in the file, plus offset
  double offset{0.0};    ///< in the unit of `name`
  double period{0.0};    ///< in the unit of `name`, > 0: readings jump by this and are put together, the first one to
                         ///< within half of it about 0; 0: they do not
};

/// A point of a picture: two columns, each by name or position, or a fixed place in the unit of the positions.
using CsvPoint = std::variant<std::array<std::string, 2>, std::array<double, 2>>;

/// An angle from positions: that of the line from straight down, or from `against`, positive towards +x.
struct CsvMarkers {
  std::string name{};              ///< ours: "bending_angle_deg"
  std::array<CsvPoint, 2> line{};  ///< from, to
  std::optional<std::array<CsvPoint, 2>> against{};
  bool y_is_up{false};
  double factor{1.0};  ///< as of CsvColumn
  double offset{0.0};
};

/// How a table is laid out, as far as its reader is told. What is absent is found in the file.
struct CsvLayout {
  std::size_t skip_lines{0};              ///< which are not looked at; the names stand below
  std::optional<char> separator{};        ///< ' ': any number of blanks
  std::optional<char> decimal{};          ///< '.' or ','
  std::vector<CsvColumn> columns{};       ///< sources that the file does not have are passed over
  std::vector<CsvMarkers> markers{};      ///< the same
  std::vector<std::string> ignore{};      ///< names or positions of columns left alone, also where `columns` has them
  bool ignore_others{false};              ///< what `columns` does not name and the reader does not know is left alone
  std::optional<double> sampling_rate{};  ///< Hz, > 0; of a file without a column of time
};

/// The position that "#4" names, from 0; nothing where the text is a name.
[[nodiscard]] std::optional<std::size_t> position_in(std::string_view source) noexcept;

}  // namespace coilwright::text

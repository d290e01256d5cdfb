#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::text {

/// Text for an element or an attribute of HTML, or of any other XML: & < > " ' as entities, control characters (which
/// XML does not have) as a question mark.
[[nodiscard]] std::string escaped(std::string_view text);

/// The same for a text of several lines: line ends and tabulators stay.
[[nodiscard]] std::string escaped_lines(std::string_view text);

/// The attribute of the cells of a table's column, with a space before it: class="number" for numbers and empty cells
/// and nothing else, which are set to the right; otherwise nothing. Every row has this column.
[[nodiscard]] std::string_view class_of_column(const std::vector<std::vector<std::string>>& rows, std::size_t column);

/// JSON as it may stand inside a script element of HTML: the same value, with every < written as \u003c (JSON has
/// one inside of texts alone), and without line ends and the indents behind them (which a text of JSON cannot have).
[[nodiscard]] std::string script_json(std::string_view json);

}  // namespace coilwright::text

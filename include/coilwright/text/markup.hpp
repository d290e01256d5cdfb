#pragma once

#include <string>
#include <string_view>

namespace coilwright::text {

/// Text for an element or an attribute of HTML, or of any other XML: & < > " ' as entities, control characters (which
/// XML does not have) as a question mark.
[[nodiscard]] std::string escaped(std::string_view text);

/// The same for a text of several lines: line ends and tabulators stay.
[[nodiscard]] std::string escaped_lines(std::string_view text);

/// JSON as it may stand inside a script element of HTML: the same value, with every < written as \u003c (JSON has
/// one inside of texts alone), and without line ends and the indents behind them (which a text of JSON cannot have).
[[nodiscard]] std::string script_json(std::string_view json);

}  // namespace coilwright::text

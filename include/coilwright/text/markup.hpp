#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coilwright::text {

/// Escapes a text for an element or an attribute of HTML or XML: & < > " ' become entities, and control characters,
/// which XML does not have, become question marks.
[[nodiscard]] std::string escaped(std::string_view text);

/// Escapes a text of several lines; line ends and tabs stay.
[[nodiscard]] std::string escaped_lines(std::string_view text);

/// A table of HTML. Every row is as long as the header. Columns of only numbers and empty cells have class="number". A
/// name may be broken after its underscores. A table of more than three columns (class "stack") can set its rows below
/// each other on a narrow screen, each cell beside its heading in data-label; one of more than twenty rows has class
/// "long". An empty caption is left out.
[[nodiscard]] std::string html_table(const std::vector<std::string>& header,
                                     const std::vector<std::vector<std::string>>& rows, std::string_view caption = {});

/// JSON for a script element of HTML: the same value, with every < (which occurs only inside texts) written as \u003c,
/// and without line ends and the indents behind them (which a text of JSON cannot have).
[[nodiscard]] std::string script_json(std::string_view json);

}  // namespace coilwright::text

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coilwright::text {

/// Text for an element or an attribute of HTML, or of any other XML: & < > " ' as entities, control characters (which
/// XML does not have) as a question mark.
[[nodiscard]] std::string escaped(std::string_view text);

/// The same for a text of several lines: line ends and tabulators stay.
[[nodiscard]] std::string escaped_lines(std::string_view text);

/// A table from its first to its last tag; every row is as long as the header. Columns of nothing but numbers and empty
/// cells have class="number". A name may be broken behind its underscores. On a narrow screen a table of more than
/// three columns (class "stack") can so have its rows below each other, each cell beside the heading that it carries as
/// data-label; one of more than twenty rows has class "long". Without a caption none is written.
[[nodiscard]] std::string html_table(const std::vector<std::string>& header,
                                     const std::vector<std::vector<std::string>>& rows, std::string_view caption = {});

/// JSON as it may stand inside a script element of HTML: the same value, with every < written as \u003c (JSON has
/// one inside of texts alone), and without line ends and the indents behind them (which a text of JSON cannot have).
[[nodiscard]] std::string script_json(std::string_view json);

}  // namespace coilwright::text

#pragma once

#include <fmt/format.h>

#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace coilwright::exports {

/// Sets an attribute, after those that are there.
inline void set(pugi::xml_node node, const char* name, std::string_view value) {
  node.append_attribute(name).set_value(std::string(value).c_str());
}
/// The same for a number, with the fewest digits that read back as the same double.
inline void set(pugi::xml_node node, const char* name, double value) {
  set(node, name, fmt::format("{}", value));
}

/// What may stand in a comment: two hyphens in a row may not, nor one at the end.
[[nodiscard]] std::string comment_text(std::string text);

/// The document as UTF-8 text, two spaces a level.
[[nodiscard]] std::string text_of(const pugi::xml_document& document);

}  // namespace coilwright::exports

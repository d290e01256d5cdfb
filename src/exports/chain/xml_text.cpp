#include "exports/chain/xml_text.hpp"

#include <sstream>

namespace coilwright::exports {

std::string comment_text(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 1))
    text.insert(at + 1, 1, ' ');
  if (!text.empty() && text.back() == '-') text += ' ';
  return text;
}

std::string text_of(const pugi::xml_document& document) {
  std::ostringstream out;
  document.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
  return out.str();
}

}  // namespace coilwright::exports

#include "coilwright/text/json/document.hpp"

#include "reads_or_refuses.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return coilwright::fuzz::reads_or_refuses(
      data, size, [](std::string_view text) { (void)coilwright::text::parse_json(text, "x"); });
}

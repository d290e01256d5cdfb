#include "coilwright/formats/simulation/commanded_input_file.hpp"

#include "reads_or_refuses.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return coilwright::fuzz::reads_or_refuses(
      data, size, [](std::string_view text) { (void)coilwright::formats::parse_commanded_input(text, "x"); });
}

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "coilwright/text/input_error.hpp"

namespace coilwright::fuzz {

/// Gives the bytes to a reader: it may return or refuse them in one line; anything else is a finding.
template <class Read>
int reads_or_refuses(const std::uint8_t* data, std::size_t size, Read read) {
  try {
    read(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const text::InputError& error) {
    if (std::string_view(error.what()).find_first_of("\n\r") != std::string_view::npos) std::abort();
  }
  return 0;
}

}  // namespace coilwright::fuzz

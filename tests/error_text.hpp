#pragma once

#include <stdexcept>
#include <string>

namespace coilwright {

/// What the std::invalid_argument says that `call` throws; empty when it throws none.
template <typename Call>
std::string error_text(Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

}  // namespace coilwright

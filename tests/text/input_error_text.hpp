#pragma once

#include <string>
#include <utility>

#include "coilwright/text/input_error.hpp"

namespace coilwright::text::testing {

/// What `action` says when it refuses its input, or "accepted".
template <class Action>
std::string error_of(Action&& action) {
  try {
    std::forward<Action>(action)();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace coilwright::text::testing

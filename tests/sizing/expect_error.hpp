#pragma once

#include <gtest/gtest.h>

#include <string>

namespace coilwright::sizing::testing {

/// Fails unless `call` throws an `Exception` whose text is exactly `text`.
template <typename Exception, typename Call>
void expect_error(Call&& call, const std::string& text) {
  try {
    call();
    ADD_FAILURE() << "nothing was thrown; expected: " << text;
  } catch (const Exception& error) {
    EXPECT_EQ(error.what(), text);
  }
}

}  // namespace coilwright::sizing::testing

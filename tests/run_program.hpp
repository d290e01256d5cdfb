#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <exception>

/// Runs the body of a small program: an exception ends it with exit code 2 and one line on standard error.
template <typename Body>
int run_program(const char* name, Body&& body) {
  try {
    return body();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 2;
  }
}

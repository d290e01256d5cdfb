#pragma once

namespace coilwright::cli {

/// How the program ends; the numbers are part of its interface.
enum class ExitCode : int {
  done = 0,
  failure = 1,       ///< anything else
  bad_input = 2,     ///< an input or the usage is wrong, or a place for results cannot be written
  infeasible = 3,    ///< no design keeps all limits; the least infeasible one is written
  interrupted = 130  ///< stopped by a signal; what was found so far is written
};

/// What a command leaves behind.
struct Outcome {
  ExitCode code = ExitCode::done;
};

}  // namespace coilwright::cli

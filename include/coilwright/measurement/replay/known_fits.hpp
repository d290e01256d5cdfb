#pragma once

#include <functional>
#include <optional>
#include <string>

namespace coilwright::measurement::replay {

/// Finished fits that outlive the program, as bytes by the bytes of all that each is a function of beside the data set,
/// the declared model and the program. The functions may be called from several threads at once, and fail in silence:
/// a fit that is not recalled is made. One that is recalled is evaluated again where it ended before it is believed:
/// where other residuals, predictions or derivatives come out, it is made anew, and `differs` is told.
struct KnownFits {
  std::function<std::optional<std::string>(const std::string& asked)> recall{};
  std::function<void(const std::string& asked, const std::string& found)> keep{};
  std::function<void()> differs{};  ///< may be empty
};

}  // namespace coilwright::measurement::replay

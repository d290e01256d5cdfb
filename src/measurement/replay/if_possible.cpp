#include "measurement/replay/if_possible.hpp"

#include <stdexcept>
#include <system_error>

namespace coilwright::measurement::replay {

std::optional<std::string> refusal_of(const std::function<void()>& make) {
  try {
    make();
  } catch (const std::system_error&) {
    throw;
  } catch (const std::invalid_argument& rule) {
    return rule.what();
  } catch (const std::domain_error& range) {
    return range.what();
  } catch (const std::runtime_error& lost) {
    return lost.what();
  }
  return std::nullopt;
}

}  // namespace coilwright::measurement::replay

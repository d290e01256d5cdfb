#include "names_once.hpp"

#include <cstddef>
#include <string_view>

#include "coilwright/text/argument.hpp"

namespace coilwright::cli {

void require_names_once(std::span<const std::string> arguments) {
  const auto name_of = [](std::string_view argument) { return argument.substr(0, argument.find('=')); };
  for (std::size_t i = 0; i < arguments.size(); ++i)
    for (std::size_t earlier = 0; earlier < i; ++earlier)
      if (name_of(arguments[earlier]) == name_of(arguments[i]))
        throw text::argument_error(arguments[i], "must not be there twice: " + arguments[earlier] + " sets it too");
}

}  // namespace coilwright::cli

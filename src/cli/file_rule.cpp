#include "file_rule.hpp"

#include <string>

namespace coilwright::cli {

CLI::Validator file_rule() {
  const auto complaint = [](std::string& argument) {
    return argument == "-" ? std::string("must be a file, which is read twice; got \"-\", standard input")
                           : std::string();
  };
  return CLI::Validator(complaint, "");
}

}  // namespace coilwright::cli

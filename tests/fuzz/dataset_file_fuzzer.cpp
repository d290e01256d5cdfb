#include "coilwright/formats/data/dataset_file.hpp"

#include "coilwright/formats/data/run_file.hpp"
#include "reads_or_refuses.hpp"

namespace {

using namespace coilwright;

// What begins with a brace is a dataset.json, whose files are not there; all else is a run of the kind that the first
// byte says.
void read(std::string_view text) {
  if (text.empty() || text.front() == '{') {
    (void)formats::parse_dataset(text, "x");
    return;
  }
  constexpr unsigned kinds = 5;
  const auto kind = static_cast<measurement::data::RunKind>(static_cast<unsigned char>(text.front()) % kinds);
  (void)formats::parse_run(text.substr(1), "x", {.name = "x", .kind = kind, .sigma = 0.3});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return coilwright::fuzz::reads_or_refuses(data, size, read);
}

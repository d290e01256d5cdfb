#include "page/result_pages.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "temporary_folder.hpp"

namespace coilwright::page {
namespace {

// What the section of a page says where the summary of the folder is this.
std::vector<std::string> paragraphs_of(const std::string& summary) {
  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "summary.txt") << summary;
  const text::Document diagnosis = text::parse_json(R"({"next_experiment": null})", "diagnosis.json");
  std::vector<std::string> out;
  for (const Block& block : next_section(folder.path(), diagnosis.root()).blocks)
    if (const auto* paragraph = std::get_if<Paragraph>(&block)) out.push_back(paragraph->text);
  return out;
}

TEST(NextSection, SaysWhatElseItCouldBeAsTheSummaryDoes) {
  EXPECT_EQ(paragraphs_of("finger: explained\n\nHow sure, and what else it could be\n"
                          "  These data cannot tell apart: coil_heating, magnet_heating.\n"
                          "  Compared, best first\n    coil_heating  1.0\n\n"
                          "What to do next\n  Go on with actuator.json.\n"),
            (std::vector<std::string>{"Go on with actuator.json.",
                                      "These data cannot tell apart: coil_heating, magnet_heating.",
                                      "No run is proposed that would separate explanations."}));
}

// A page without its verdict or its doubts would say more than is known.
TEST(NextSection, IsRefusedWhereTheSummaryLacksASection) {
  try {
    (void)paragraphs_of("finger: explained\n\nThe declared model lacks dry_friction.\n");
    FAIL();
  } catch (const text::InputError& error) {
    EXPECT_THAT(error.what(), ::testing::EndsWith("summary.txt: must have the section \"What to do next\""));
  }
}

}  // namespace
}  // namespace coilwright::page

#include "page/result_words.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <string>

#include "coilwright/text/input_error.hpp"
#include "temporary_folder.hpp"

namespace coilwright::page {
namespace {

// Why a summary is refused as that of a data set with the verdict "explained"; empty if it is not.
std::string fault_of(const std::string& summary, const std::string& dataset = "finger") {
  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "summary.txt") << summary;
  try {
    require_summary_of(folder.path(), dataset, "explained");
  } catch (const text::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SummaryText, BelongsToTheDiagnosisBesideIt) {
  EXPECT_EQ(fault_of("finger\nof Monday: explained\n\nThe declared model lacks\n", "finger\nof Monday"), "");
  EXPECT_EQ(fault_of("finger: explained\n\nThe declared model lacks dry_friction.\n"), "");
  EXPECT_THAT(
      fault_of("gripper: explained\n\nThe declared model lacks dry_friction.\n"),
      ::testing::EndsWith("summary.txt: must begin with \"finger: explained\", as diagnosis.json beside it has it; "
                          "got \"gripper: explained\""));
  EXPECT_THAT(fault_of("finger: unexplained\n\nThe declared model lacks something.\n"),
              ::testing::EndsWith("got \"finger: unexplained\""));
  EXPECT_THAT(fault_of(""), ::testing::EndsWith("got \"\""));
}

}  // namespace
}  // namespace coilwright::page

#include "page/result_pages.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/page/pages.hpp"
#include "coilwright/text/input_error.hpp"
#include "temporary_folder.hpp"

namespace coilwright::page {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;

constexpr const char* diagnosis_text = R"({"format": "diagnosis/1", "dataset": "finger", "verdict": "explained",
  "effects": [{"id": "dry_friction", "parameters": {"torque_Nmm": {"value": 0.5, "ci95": [0.4, 0.6]}},
               "evidence": {"probability": 0.97}}],
  "error": {"fit": {"declared": {"rmse_deg": 2}, "before": {"rmse_deg": 1}, "after": {"rmse_deg": 0.5}, "samples": 3,
                    "torque": {"declared": {"rmse_Nmm": 1}, "samples": 1}},
            "validate": {"after": {"rmse_deg": 0.6}, "samples": 1}},
  "candidates": [{"effects": ["dry_friction"], "probability": 0.97, "log_evidence": 40, "chi_square": 9,
                  "probability_of_noise": 0.9},
                 {"effects": [], "probability": 0.03, "log_evidence": 0, "chi_square": null,
                  "probability_of_noise": null}],
  "ruled_out": [{"effects": ["coil_heating"], "remark": "no coils"}],
  "warnings": [], "next_experiment": null,
  "summary": {"title": "finger: explained", "verdict": "The declared model lacks dry_friction.",
              "cautions": ["CHECK THE ZERO.\n"],
              "sections": [{"id": "next", "title": "What to do next", "blocks": ["  Go on with actuator.json.\n"]}]}})";

constexpr const char* residuals = R"(run,role,channel,time_s,angle_deg,current_A,left_out,measured,declared,before,after
a.csv,fit,theta_deg,0,,,0,1.5,1,1,1.25
a.csv,fit,theta_deg,0.1,,,1,9,1,1,2.25
a.csv,fit,theta_deg,0.2,,,0,2,1,1,2
a.csv,fit,theta_deg,0.3,,,0,2,1,1,2
b.csv,fit,torque_Nmm,,30,,0,4,5,3,4.5
c.csv,validate,theta_deg,0,,,0,1.5,1,1,1.25
)";

using Rows = std::vector<std::vector<std::string>>;

struct Folder {
  std::string diagnosis = diagnosis_text;
  std::string residual_table = residuals;

  [[nodiscard]] Page page() const {
    const testing::TemporaryFolder folder;
    folder.file("diagnosis.json", diagnosis);
    folder.file("residuals.csv", residual_table);
    return page_of(folder.path(), {});
  }
  [[nodiscard]] std::string fault() const {
    try {
      (void)page();
    } catch (const text::InputError& error) {
      return error.what();
    }
    return "";
  }
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

const Section& section(const Page& page, const std::string& id) {
  return *std::ranges::find(page.sections, id, &Section::id);
}

TEST(DiagnosisPage, HasTheWordsAndNumbersOfTheSummary) {
  const Page page = Folder().page();
  EXPECT_EQ(page.verdict, "The declared model lacks dry_friction.");
  EXPECT_THAT(page.cautions, ElementsAre("CHECK THE ZERO.\n"));
  EXPECT_EQ(std::get<Lines>(section(page, "next").blocks.at(0)).text, "  Go on with actuator.json.\n");
  // Of four samples that count a chi-square of 9 is 1.5 times the noise.
  const Table& compared = std::get<TableBlock>(section(page, "candidates").blocks[0]).table;
  EXPECT_EQ(compared.rows,
            (Rows{{"1", "dry_friction", "0.970", "40", "1.5", "0.900"}, {"2", "none", "0.030", "0", "-", "-"}}));
  const Table& ruled_out = std::get<TableBlock>(section(page, "candidates").blocks[1]).table;
  EXPECT_EQ(ruled_out.rows, (Rows{{"coil_heating", "no coils"}}));
}

TEST(DiagnosisPage, IsRefusedWithWhatIsMissing) {
  EXPECT_EQ(Folder().fault(), "");
  EXPECT_THAT(Folder{.diagnosis = replaced(diagnosis_text, R"("verdict": "explained",)", "")}.fault(),
              EndsWith("diagnosis.json: /: must have \"verdict\" (docs/formats.md)"));
  EXPECT_THAT(Folder{.diagnosis = replaced(diagnosis_text, R"("cautions")", R"("others")")}.fault(),
              EndsWith("diagnosis.json: /summary/cautions: is missing"));
  EXPECT_THAT(Folder{.diagnosis = replaced(diagnosis_text, R"("summary")", R"("words")")}.fault(),
              EndsWith("diagnosis.json: /: must have \"summary\" (docs/formats.md), which an earlier version did not "
                       "write: run it again"));
  EXPECT_THAT(
      Folder{.residual_table = replaced(residuals, "a.csv,fit,theta_deg,0.3,,,0,2,1,1,2\n", "")}.fault(),
      EndsWith("residuals.csv: must have the 4 samples of role fit that diagnosis.json beside it counts; got 3"));
}

}  // namespace
}  // namespace coilwright::page

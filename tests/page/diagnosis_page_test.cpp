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
  "summary": {"verdict": "The declared model lacks dry_friction.", "cautions": ["CHECK THE ZERO."],
              "assumptions": ["  Numbers fitted freely:", "    joint_stiffness_Nmm_rad  12.1"],
              "rivals": ["These data cannot tell apart: dry_friction, backlash."],
              "next_steps": ["Go on with actuator.json."]}})";

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

std::vector<std::string> paragraphs_of(const Section& section) {
  std::vector<std::string> out;
  for (const Block& block : section.blocks)
    if (const auto* paragraph = std::get_if<Paragraph>(&block)) out.push_back(paragraph->text);
  return out;
}

TEST(DiagnosisPage, HasTheWordsAndNumbersOfTheSummary) {
  const Page page = Folder().page();
  EXPECT_EQ(page.verdict, "The declared model lacks dry_friction.");
  EXPECT_THAT(page.cautions, ElementsAre("CHECK THE ZERO."));
  EXPECT_THAT(paragraphs_of(section(page, "next")),
              ElementsAre("Go on with actuator.json.", "These data cannot tell apart: dry_friction, backlash.",
                          "No run is proposed that would separate explanations."));
  EXPECT_EQ(std::get<Listing>(section(page, "assumptions").blocks.front()).text,
            "  Numbers fitted freely:\n    joint_stiffness_Nmm_rad  12.1");
  const Table& effects = std::get<TableBlock>(section(page, "effects").blocks.front()).table;
  EXPECT_EQ(effects.rows, (Rows{{"dry_friction", "0.97", "torque_Nmm", "0.5", "0.4 to 0.6"}}));
  const Table& errors = std::get<TableBlock>(section(page, "errors").blocks.front()).table;
  ASSERT_GE(errors.rows.size(), 1U);
  EXPECT_EQ(errors.rows[0], (std::vector<std::string>{"held out", "with effects", "rmse_deg", "0.6"}));
  // Of four samples that count a chi-square of 9 is 1.5 times the noise.
  const Table& compared = std::get<TableBlock>(section(page, "candidates").blocks[1]).table;
  EXPECT_EQ(compared.rows,
            (Rows{{"1", "dry_friction", "0.97", "40", "1.5", "0.9"}, {"2", "none", "0.03", "0", "-", "-"}}));
  const Table& ruled_out = std::get<TableBlock>(section(page, "candidates").blocks[2]).table;
  EXPECT_EQ(ruled_out.rows, (Rows{{"coil_heating", "no coils"}}));
}

TEST(DiagnosisPage, IsRefusedWithWhatIsMissing) {
  EXPECT_EQ(Folder().fault(), "");
  EXPECT_THAT(Folder{.diagnosis = replaced(diagnosis_text, R"("verdict": "explained",)", "")}.fault(),
              EndsWith("diagnosis.json: /: must have \"verdict\" (docs/formats.md)"));
  // A page without its verdict or its doubts would say more than is known.
  EXPECT_THAT(Folder{.diagnosis = replaced(diagnosis_text, R"("rivals")", R"("others")")}.fault(),
              EndsWith("diagnosis.json: /summary: must have \"rivals\" (docs/formats.md)"));
  EXPECT_THAT(Folder{.diagnosis = replaced(diagnosis_text, R"("summary")", R"("words")")}.fault(),
              EndsWith("diagnosis.json: /: must have \"summary\" (docs/formats.md), which an earlier version did not "
                       "write: diagnose again"));
  EXPECT_THAT(Folder{.diagnosis = replaced(diagnosis_text, R"("id": "dry_friction", )", "")}.fault(),
              EndsWith("diagnosis.json: /effects/0: must have \"id\" (docs/formats.md)"));
  EXPECT_THAT(
      Folder{.residual_table = replaced(residuals, "a.csv,fit,theta_deg,0.3,,,0,2,1,1,2\n", "")}.fault(),
      EndsWith("residuals.csv: must have the 4 samples of role fit that diagnosis.json beside it counts; got 3"));
}

}  // namespace
}  // namespace coilwright::page

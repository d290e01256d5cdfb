#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "coilwright/formats/data/dataset_draft.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/run_file.hpp"
#include "degree.hpp"
#include "temporary_folder.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

namespace fs = std::filesystem;
using coilwright::testing::TemporaryFolder;
using Record = measurement::data::Run;
using measurement::data::RunKind;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const fs::path records = COILWRIGHT_SOURCE_DIR "/tests/data/formats/records";

// The same motion as other programs write it; tests/data/formats_SOURCES.md says how they were made.
const std::vector<std::string> kinds = {"arduino.txt",
                                        "arduino_monitor.txt",
                                        "comsol.txt",
                                        "excel_german.csv",
                                        "excel_two_lines.csv",
                                        "keysight.csv",
                                        "hours.csv",
                                        "ros2.csv",
                                        "pandas_timedelta.csv",
                                        "labview.lvm",
                                        "matlab.csv",
                                        "numpy.txt",
                                        "pandas.csv",
                                        "picoscope.csv",
                                        "pandas_stamps.csv",
                                        "plain.csv",
                                        "r.txt",
                                        "rigol.csv",
                                        "ros.csv",
                                        "saleae.csv",
                                        "scope_beside.csv",
                                        "tektronix.csv",
                                        "tracker.txt"};

Record only_record(std::string_view document) {
  const DatasetFile set = parse_dataset(document, (records / "dataset.json").string());
  EXPECT_EQ(set.data.fit.size(), 1u);
  return set.data.fit.front();
}

std::string set_of(const std::string& file, const std::string& keys, const std::string& keys_of_run = "") {
  return R"({"format": "measured-data/1")" + (keys.empty() ? "" : ", " + keys) + R"(, "runs": [{"file": ")" + file +
         R"(", "kind": "transient", "role": "fit", "drive": "current")" +
         (keys_of_run.empty() ? "" : ", " + keys_of_run) + "}]}";
}

Record plain() {
  return only_record(set_of("plain.csv", ""));
}

void expect_plain(const Record& run) {
  const Record wanted = plain();
  ASSERT_EQ(run.samples(), wanted.samples());
  EXPECT_EQ(run.inputs, wanted.inputs);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    // A time of day in seconds, or seconds since 1970, have a part in 1e16 of their size.
    EXPECT_NEAR(run.times[i] - run.times.front(), wanted.times[i], 3e-7);
    EXPECT_NEAR(run.channels.front().values[i], wanted.channels.front().values[i], 1e-12);
  }
}

std::string refusal_of(const std::string& document) {
  return text::testing::error_of([&] { (void)parse_dataset(document, (records / "dataset.json").string()); });
}

// What an error says is to be written into dataset.json.
std::string cure_in(const std::string& error) {
  const std::size_t write = error.find("write");
  if (write == std::string::npos) return "";
  std::string cure = error.substr(error.find(": \"", write) + 2);
  for (const std::string_view end : {"} (", "] (", "0 ("})
    if (const std::size_t at = cure.find(end); at != std::string::npos) cure.resize(at + 1);
  return cure;
}

TEST(Layout, OfADraftReadsWhatOtherProgramsWrite) {
  for (const std::string& kind : kinds) {
    SCOPED_TRACE(kind);
    const DatasetDraft draft = draft_dataset(std::vector{records / kind}, records, "actuator.json");
    EXPECT_THAT(draft.asked, IsEmpty());
    expect_plain(only_record(draft.document.text()));
  }
}

TEST(Layout, IsToldByTheErrorThatRefusesAFile) {
  std::size_t refused = 0;
  for (const std::string& kind : kinds) {
    SCOPED_TRACE(kind);
    const std::string error = refusal_of(set_of(kind, ""));
    if (error == "accepted") continue;
    ++refused;
    expect_plain(only_record(set_of(kind, cure_in(error))));
    expect_plain(only_record(set_of(kind, "", cure_in(error))));
  }
  EXPECT_EQ(refused, kinds.size() - 2);  // plain.csv, and numpy.txt, whose comment has our names
}

TEST(Layout, TakesAlternatingRowsAsTwoClocks) {
  const std::string keys =
      R"("columns": {"__time": "time_s", "/coil/current": "current_A", "/finger/angle": "bending_angle_deg"})";
  const DatasetFile set = parse_dataset(set_of("plotjuggler.csv", keys), (records / "dataset.json").string());
  const Record& run = set.data.fit.front();
  const Record wanted = plain();
  EXPECT_TRUE(run.has_input_clock());
  EXPECT_EQ(run.clock.offset_sigma, 0.0);  // it is one clock
  EXPECT_EQ(run.inputs, wanted.inputs);
  ASSERT_EQ(run.samples(), wanted.samples());
  for (std::size_t i = 0; i < run.samples(); ++i) {
    EXPECT_NEAR(run.input_times[i], wanted.times[i], 3e-7);
    EXPECT_NEAR(run.times[i], wanted.times[i] + 0.0007, 3e-7);
    EXPECT_EQ(run.channels[0].values[i], wanted.channels[0].values[i]);
  }
  ASSERT_EQ(set.data.warnings.size(), 1u);
  EXPECT_EQ(set.data.warnings[0].text,
            "40 of 80 rows have measured values, and 40 an input; each is taken at the times that it has");
}

TEST(Layout, RefusesAReadingThatWrapsAndPutsItTogetherWhereThatIsSaid) {
  const std::string error = refusal_of(set_of("wrapped.csv", ""));
  EXPECT_THAT(error,
              EndsWith("wraps at 360 deg. To have it put together, give the column \"wraps_deg\" in dataset.json: "
                       "\"columns\": {\"bending_angle_deg\": {\"as\": \"bending_angle_deg\", \"wraps_deg\": "
                       "360.0}}; got 1.03"));
  const Record run = only_record(
      set_of("wrapped.csv",
             R"("columns": {"bending_angle_deg": {"as": "bending_angle_deg", "wraps_deg": 360, "offset": 10}})"));
  expect_plain(run);
}

class OwnRecords : public ::testing::Test {
 protected:
  Record read(const std::string& keys, const std::string& text) {
    write("a.csv", text);
    const DatasetFile set = read_dataset(folder_.file("dataset.json", set_of("a.csv", keys)));
    warnings_ = set.data.warnings;
    return set.data.fit.front();
  }
  std::string refusal(const std::string& keys, const std::string& text, const std::string& keys_of_run = "") {
    write("a.csv", text);
    const fs::path path = folder_.file("dataset.json", set_of("a.csv", keys, keys_of_run));
    const std::string error = text::testing::error_of([&] { (void)read_dataset(path); });
    const std::string place = folder_.path().string() + "/";
    return error.starts_with(place) ? error.substr(place.size()) : error;
  }
  void write(const std::string& name, const std::string& text) { (void)folder_.file(name, text); }

  TemporaryFolder folder_;
  std::vector<measurement::data::Warning> warnings_;
};

const std::string table = "Zeit,Strom,Winkel\n0,0,-7\n0.1,50,-8\n0.2,100,-9\n";

TEST_F(OwnRecords, AreScaledTurnedAndShifted) {
  const Record run = read(R"("columns": {"Zeit": "time_s", "Strom": {"as": "current_A", "factor": 0.014},
                                      "Winkel": {"as": "bending_angle_deg", "factor": -1, "offset": 2}})",
                          table);
  EXPECT_THAT(run.inputs,
              ElementsAre(ElementsAre(0.0), ElementsAre(DoubleNear(0.7, 1e-15)), ElementsAre(DoubleNear(1.4, 1e-15))));
  EXPECT_THAT(run.channels[0].values, ElementsAre(DoubleNear(9 * degree, 1e-15), DoubleNear(10 * degree, 1e-15),
                                                  DoubleNear(11 * degree, 1e-15)));
}

// What has no unit in its name and more than one by its numbers is asked, and the cure is one of those that are told.
TEST_F(OwnRecords, AreAskedForAUnitOfTimeThatNumbersDoNotTell) {
  const auto rows = [](double step) {
    std::string out = "t,current_A,bending_angle_deg\n";
    for (int i = 0; i < 12; ++i) out += fmt::format("{},{},{}\n", i * step, i / 4, 7 + i % 3);
    return out;
  };
  EXPECT_THAT(
      refusal("", rows(0.002 / 3600.0)),
      HasSubstr(
          R"(dataset.json must say what "t" counts: "columns": {"t": "time_h"} or "columns": {"t": "time_day"})"));
  EXPECT_NEAR(read(R"("columns": {"t": "time_h"})", rows(0.002 / 3600.0)).times[1], 0.002, 1e-12);
  EXPECT_THAT(refusal("", rows(1.0)),
              HasSubstr(R"(goes up by ones: of pictures or rows "columns": {"t": {"as": "time_s", )"
                        R"("factor": F}})"));
  EXPECT_NEAR(read(R"("columns": {"t": {"as": "time_s", "factor": 0.0166666667}})", rows(1.0)).times[11], 11 / 60.0,
              1e-8);
}

// Seconds and the part of one are joined only where they are that.
TEST_F(OwnRecords, JoinSecondsAndTheirPart) {
  const std::string rows = "sec,nanosec,current_A,theta1_deg\n12,999000000,0,7\n13,1000000,1,8\n13,3000000,1,9\n";
  const std::string keys = R"("columns": {"sec": "time_s", "nanosec": "time_ns"})";
  EXPECT_THAT(read(keys, rows).times,
              ElementsAre(DoubleNear(12.999, 1e-12), DoubleNear(13.001, 1e-12), DoubleNear(13.003, 1e-12)));
  EXPECT_THAT(refusal("", rows), HasSubstr(keys));
  EXPECT_THAT(refusal(keys, "sec,nanosec,current_A,theta1_deg\n12,12000000000,0,7\n13,13000000000,1,8\n"),
              EndsWith("column \"nanosec\" as time_ns: must not be there twice"));
  std::string later = rows;
  for (int i = 0; i < 9000; ++i) later += fmt::format("{},5000000,1,9\n", 14 + i);
  EXPECT_THAT(refusal(keys, later + "9999,-1,1,9\n"), HasSubstr("must be a finite number"));
}

TEST_F(OwnRecords, AreToldByWhatWasMeasuredAndNotBySetpoints) {
  const std::string error = refusal(
      "",
      "Time (s),Current set (A),Current (mA),Setpoint angle (deg),Measured angle (deg)\n0,2,0,30,7\n0.1,2,700,30,8\n");
  EXPECT_THAT(error, HasSubstr("\"Current (mA)\": \"current_mA\", \"Measured angle (deg)\": \"bending_angle_deg\"}, "
                               "\"ignore\": [\"Current set (A)\", \"Setpoint angle (deg)\"]"));
  EXPECT_THAT(error, HasSubstr("\"Setpoint angle (deg)\" is left alone: another column is taken for it"));
}

TEST_F(OwnRecords, AreAskedForAUnitThatNobodyKnows) {
  const std::string error = refusal("", "Time (s),Current (A),Angle (gon)\n0,0,7\n0.1,1,8\n");
  EXPECT_THAT(error, HasSubstr("the unit \"gon\": \"columns\": {\"Angle (gon)\": {\"as\": \"bending_angle_deg\", "
                               "\"factor\": F}} with F the deg in one of it"));
  EXPECT_THAT(refusal("", "time_s,current_A,bending_angle_rev\n0,0,0.01\n0.1,1,0.02\n"), HasSubstr("the unit \"rev\""));
}

TEST_F(OwnRecords, MayHaveTheMinusSignOfEditors) {
  const Record run = read("",
                          "time_s,current_A,bending_angle_deg\n0,\xe2\x88\x92"
                          "0.5,7\n0.1,1,8\n");
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(-0.5), ElementsAre(1.0)));
}

TEST_F(OwnRecords, MayHaveSettingsAsWideAsTheirRowsAboveTheNames) {
  const Record run = read(
      R"("sampling_rate_Hz": 500, "columns": {"Strom": "current_A", "Winkel": "bending_angle_deg"})",
      "LabVIEW Measurement\t\nDelta_X\t0.002\t0.002\t\n***End_of_Header***\t\t\t\nX_Value\tStrom\tWinkel\tComment\n"
      "\t0\t7\t\n\t0.5\t8\t\n\t1\t9\t\n");
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(0.0), ElementsAre(0.5), ElementsAre(1.0)));
}

TEST_F(OwnRecords, MayBeInAnyUnitOfTheSameDimension) {
  const Record run = read("", "time_us,current_mA,theta1_mrad\n0,0,7\n1000,700,8\n");
  EXPECT_THAT(run.times, ElementsAre(0.0, 0.001));
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(0.0), ElementsAre(0.7)));
  EXPECT_THAT(run.channels[0].values, ElementsAre(0.007, 0.008));
}

TEST_F(OwnRecords, TellADutyThatNeedsAScale) {
  EXPECT_THAT(refusal("", "time_s,duty_pct,theta1_deg\n0,0,7\n1,50,8\n2,50,9\n"),
              HasSubstr("dataset.json must say what \"duty_pct\" stands for: \"columns\": {\"duty_pct\": {\"as\": "
                        "\"voltage_V\", \"factor\": F}} with F the supply in volts over the largest number"));
}

TEST_F(OwnRecords, MustFitWhatTheirEntriesName) {
  const std::string columns = R"("columns": {"Zeit": "time_s", "Strom": "current_A", "Winkel": "theta1_deg"})";
  EXPECT_EQ(refusal("", table, R"("columns": {"Zeit": "time_s", "Storm": "current_A"})"),
            "a.csv: line 1: column Storm: is not there, and the run's \"columns\" names it; the columns are \"Zeit\", "
            "\"Strom\", \"Winkel\"");
  EXPECT_EQ(refusal(columns + R"(, "ignore": ["frame"])", table), "dataset.json: /ignore/0: fits no file of the set");
  EXPECT_EQ(
      refusal(columns, table, R"("sampling_rate_Hz": 100)"),
      "a.csv: line 1: has a column of time, and the run a \"sampling_rate_Hz\": one of the two must go (\"ignore\" "
      "leaves a column alone)");
  EXPECT_EQ(refusal(columns + R"(, "sampling_rate_Hz": 100)", table),
            "dataset.json: /sampling_rate_Hz: fits no file of the set");
  EXPECT_EQ(refusal(R"("columns": {"Zeit": "seconds"})", table),
            "dataset.json: /columns/Zeit: must be a column of ours with the unit of the file's numbers, such as "
            "\"time_ms\" or \"current_A\"; got text \"seconds\"");
  EXPECT_EQ(refusal(R"("ignore": [1])", table),
            "dataset.json: /ignore/0: must be a column's name, or its position as a text: \"#1\" is the first; got 1");
  EXPECT_EQ(refusal(R"("columns": {"Zeit": {"as": "time_s", "wraps_deg": 360}})", table),
            "dataset.json: /columns/Zeit/wraps_deg: must be there for an angle only");
  EXPECT_EQ(refusal(R"("columns": {"Zeit": {"as": "time_s", "factor": 0}})", table),
            "dataset.json: /columns/Zeit/factor: must not be 0; got 0");
}

TEST_F(OwnRecords, MayLackTimesWhereTheRateIsGiven) {
  EXPECT_THAT(
      read(R"("sampling_rate_Hz": 50, "ignore": "others")", "n,current_A,theta1_deg,x\n0,0,7,a\n1,0,8,b\n").times,
      ElementsAre(0.0, 0.02));
}

TEST_F(OwnRecords, NameTheRowsThatAreToGo) {
  const std::string header = "time_s,current_A,theta1_deg\n";
  EXPECT_EQ(
      refusal(
          "",
          header + "0,0,7\n0,0,7\n0.1,0,7\n0.2,0,7\n0.2,0,7\n0.3,0,7\n0.4,0,8\n0.5,0,8\n0.6,0,9\n0.7,0,9\n0.8,0,9\n"),
      "a.csv: line 3: column time_s: must exceed the value before it (0); delete the lines 3, 6, which repeat the "
      "time of the row above; got 0");
  EXPECT_EQ(
      refusal("", header + "0,0,7\n0.1,0,7\n0.2,0,7\n0,0,7\n0.1,0,7\n0.2,0,7\n"),
      "a.csv: line 5: column time_s: must exceed the value before it (0.2); the clock starts again here, so the "
      "file holds 2 records: make a file of each, with the line of names, and a run of each in dataset.json; got 0");
  EXPECT_EQ(
      refusal("", header + "0,0,7\n0.2,0,7\n0.1,0,7\n0.3,0,7\n0.4,0,7\n"),
      "a.csv: line 4: column time_s: must exceed the value before it (0.2); the rows are out of order: sort them by "
      "this column; got 0.1");
  EXPECT_EQ(
      refusal("", "time_ms,current_A,theta1_deg\n0,0,7\n0,0,7\n1,0,7\n1,0,7\n2,0,7\n2,0,7\n3,0,7\n3,0,7\n4,0,7\n"),
      "a.csv: line 3: column time_ms: must exceed the value before it (0); 4 of 9 rows repeat a time, as the clock "
      "is too coarse: if the rows are evenly spaced, they are 2000 a second by the first and the last; in "
      "dataset.json, give that as \"sampling_rate_Hz\", and \"time_ms\" in \"ignore\"; got 0");
  std::string junk = header;
  for (int i = 0; i < 16; ++i) junk += std::to_string(i) + (i == 3 || i == 7 ? ",\x01,7\n" : i == 9 ? "\n" : ",0,7\n");
  EXPECT_EQ(
      refusal("", junk),
      "a.csv: line 5: column current_A: must be a finite number (delete the line if it is damaged, and lines 9, 11); "
      "got \"\\x01\"");
  EXPECT_THAT(refusal("", "time_s,current_A,theta1_deg,theta2_deg\n0,0,,\n0.1,,7,\n0.2,,,7\n0.3,0,,\n0.4,,7,\n"),
              HasSubstr("line 3: column theta2_deg: must have a value where others of its kind have"));
}

TEST_F(OwnRecords, MayMissAReadingHereAndThere) {
  const Record run = read("", "time_s,current_A,theta1_deg\n0,0,7\n0.1,0.5,nan\n0.2,0.5,8\n");
  EXPECT_THAT(run.times, ElementsAre(0.0, 0.2));
  EXPECT_THAT(run.input_times, ElementsAre(0.0, 0.1, 0.2));
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(0.0), ElementsAre(0.5), ElementsAre(0.5)));
  ASSERT_EQ(warnings_.size(), 1u);
}

// Marks on a bar at a known angle, seen by a camera whose y goes down, and against a base that leans.
TEST_F(OwnRecords, HaveAnglesOfMarkers) {
  const auto film = [](double y_sign) {
    std::string text = "time_s,current_A,px,py,qx,qy,rx,ry\n";
    for (int i = 0; i < 6; ++i) {
      const double angle = (-20.0 + 90.0 * i) * degree, base = 5.0 * degree;
      const auto at = [](double value) { return std::to_string(value); };
      text += at(0.1 * i) + ",0," + at(300) + "," + at(200) + "," + at(300 + 80 * std::sin(angle)) + "," +
              at(200 + y_sign * 80 * std::cos(angle)) + "," + at(300 + 40 * std::sin(base)) + "," +
              at(200 + y_sign * 40 * std::cos(base)) + "\n";
    }
    return text;
  };
  const std::string line = R"("line": [["px", "py"], ["qx", "qy"]])";
  for (const bool up : {false, true}) {
    const std::string keys = R"("ignore": "others", "markers": {"bending_angle_deg": {)" + line +
                             (up ? R"(, "y": "up")" : "") + R"(, "against": [[300, 200], ["rx", "ry"]], "offset": 1}})";
    const Record run = read(keys, film(up ? -1.0 : 1.0));
    for (int i = 0; i < 6; ++i)  // beyond half a turn, and the positions have six decimals
      EXPECT_NEAR(run.channels[0].values[i], (-20.0 + 90.0 * i - 5.0 + 1.0) * degree, 1e-7);
  }
  const Record opposite =
      read(R"("ignore": "others", "markers": {"theta1_rad": {)" + line + R"(, "factor": -1}})", film(1.0));
  EXPECT_NEAR(opposite.channels[0].values[0], 20.0 * degree, 1e-7);
  EXPECT_EQ(
      refusal(R"("markers": {"bending_angle_deg": {"line": [["px", "py"], ["px", "py"]]}})",
              "time_s,current_A,px,py\n0,0,1,2\n1,0,1,2\n"),
      "a.csv: line 2: has both points of a line of \"markers\" in one place: no direction can be told (1 more rows "
      "are like it)");
  EXPECT_EQ(refusal("", film(1.0), R"("markers": {"bending_angle_deg": {"line": [["px", "py"], ["tip", "qy"]]}})"),
            "a.csv: line 1: column tip: is not there, and the run's \"markers\" names it; the columns are \"time_s\", "
            "\"current_A\", \"px\", \"py\", \"qx\", \"qy\", \"rx\", \"ry\"");
}

TEST_F(OwnRecords, ShareAClockWithAnInputFileThatHasADate) {
  write("i.csv", "stamp,I\n2021-01-20 10:11:31.900,0\n2021-01-20 10:11:32.100,700\n2021-01-20 10:11:32.300,700\n");
  const std::string input = R"("input_file": {"file": "i.csv", "columns": {"stamp": "time_s", "I": "current_mA"}})";
  write("dataset.json", set_of("a.csv", "", R"("columns": {"stamp": "time_s"}, )" + input));
  write("a.csv", "stamp,theta1_deg\n2021-01-20T10:11:32.000Z,7\n2021-01-20T10:11:32.200Z,8\n");
  const Record run = read_dataset(folder_.path() / "dataset.json").data.fit.front();
  EXPECT_THAT(run.times, ElementsAre(0.0, DoubleNear(0.2, 1e-9)));
  EXPECT_THAT(run.input_times, ElementsAre(DoubleNear(-0.1, 1e-9), DoubleNear(0.1, 1e-9), DoubleNear(0.3, 1e-9)));
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(0.0), ElementsAre(0.7), ElementsAre(0.7)));
  // A film whose pictures have no date.
  write("a.csv", "n,theta1_deg\n0,7\n1,8\n");
  const std::string film = R"("sampling_rate_Hz": 10, "ignore": ["n"], )" + input;
  EXPECT_THAT(
      refusal("", "n,theta1_deg\n0,7\n1,8\n", film),
      HasSubstr("must count from the zero that a.csv counts from: one of the two has a date or a number of many "
                "digits, the other has not. With \"clock_offset_s\" in its run"));
  EXPECT_EQ(refusal("", "n,theta1_deg\n0,7\n1,8\n", film + R"(, "clock_offset_s": 0.05)"), "accepted");
}

TEST_F(OwnRecords, SayWhetherACommaPartsThousands) {
  const std::string text = "time_ms;current_mA;theta1_deg\n0;1,400;7\n2;1,400;7\n";
  EXPECT_EQ(
      refusal("", text),
      "a.csv: line 2: must have decimals that cannot be taken for thousands: write them with a point, and thousands "
      "without a comma (dataset.json of a data set may say \"decimal\": \",\"); got \"1,400\"");
  EXPECT_THAT(read(R"("decimal": ",")", text).inputs, ElementsAre(ElementsAre(0.0014), ElementsAre(0.0014)));
}

}  // namespace
}  // namespace coilwright::formats

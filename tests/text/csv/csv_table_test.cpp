#include "coilwright/text/csv/csv_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <locale>
#include <numbers>
#include <string>

#include "temporary_folder.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::text {
namespace {

using coilwright::testing::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::StartsWith;

void ask_for_bench(CsvHeader& header) {
  header.require("angle_deg");
  header.require("current_A");
  (void)header.find("torque_Nmm");
}

CsvTable bench(std::string_view text) {
  return parse_csv(text, "x.csv", ask_for_bench);
}

std::string table_refusal(std::string_view text) {
  return testing::error_of([&] { (void)bench(text); });
}

TEST(CsvTable, GivesColumnsInSi) {
  const CsvTable table = bench("angle_deg,current_A,torque_Nmm\n90,0.7,-9.9\n-45,1.4,4.35\n");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_THAT(table.column("angle"), ElementsAre(std::numbers::pi / 2, -std::numbers::pi / 4));
  EXPECT_THAT(table.column("current"), ElementsAre(0.7, 1.4));
  EXPECT_THAT(table.column("torque"), ElementsAre(-0.0099, 0.00435));
}

TEST(CsvTable, TakesAnyUnitOfTheSameDimension) {
  const CsvTable table = bench("torque_Nm,current_A,angle_rad\n0.0099,0.7,1.25\n");
  EXPECT_THAT(table.column("angle"), ElementsAre(1.25));
  EXPECT_THAT(table.column("torque"), ElementsAre(0.0099));
}

TEST(CsvTable, ReadsQuotedFieldsPlusSignsSpacesAndEveryKindOfLineEnd) {
  for (const std::string_view text : {"angle_deg,current_A\n2.5,3.5\n4.5,5.5\n",    //
                                      "angle_deg,current_A\r\n2.5,3.5\r\n4.5,5.5",  //
                                      "angle_deg,current_A\r2.5,3.5\r4.5,5.5\r",    //
                                      "\xef\xbb\xbf\"angle_deg\",current_A\n2.5,+3.5\n\n4.5 ,\t\"5.5\"\n\n",
                                      "angle_deg , current_A\n2.5e0,35e-1\n4.5,5.5\n"}) {
    const CsvTable table = bench(text);
    const auto current = table.column("current");
    EXPECT_EQ(table.column("angle")[1], 4.5 * std::numbers::pi / 180) << text;
    EXPECT_THAT(std::vector(current.begin(), current.end()), ElementsAre(3.5, 5.5)) << text;
  }
}

TEST(CsvTable, IgnoresTheLocale) {
  struct CommaDecimals : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaDecimals));
  const CsvTable table = bench("angle_deg,current_A\n2.5,3.5\n");
  std::locale::global(before);
  EXPECT_EQ(table.column("current")[0], 3.5);
}

// As Windows and spreadsheets write them.
TEST(CsvTable, SaysWhatAFileIsThatIsNoText) {
  constexpr std::string_view utf16(
      "\xff\xfe"
      "a\0n\0g\0l\0e\0\n\0",
      14);
  EXPECT_EQ(table_refusal(utf16),
            "x.csv: must be UTF-8, and is UTF-16: save it anew as UTF-8 (\"CSV UTF-8\" of a spreadsheet)");
  EXPECT_EQ(table_refusal("PK\x03\x04 xl/worksheets"),
            "x.csv: must be text, and is a spreadsheet or an archive: export it as CSV");
  EXPECT_EQ(table_refusal(std::string_view("\x01\0\x02\n", 4)), "x.csv: must be text, and is binary: export it as CSV");
}

TEST(CsvTable, RefusesAnEmptyFileAndOneWithoutRows) {
  EXPECT_EQ(table_refusal(""), "x.csv: is empty: it must have a header");
  EXPECT_EQ(table_refusal("\n \n"), "x.csv: is empty: it must have a header");
  EXPECT_EQ(table_refusal("angle_deg,current_A\n"), "x.csv: must have a row below its header");
}

TEST(CsvTable, RefusesAMissingColumn) {
  EXPECT_EQ(table_refusal("angle_deg,torque_Nmm\n1.5,2.5\n"), "x.csv: line 1: column current_A: is missing");
}

TEST(CsvTable, RefusesAnUnknownColumnAndSuggestsTheOneThatWasMeant) {
  EXPECT_EQ(table_refusal("angle_deg,current_A,troque_Nmm\n1.5,2.5,3.5\n"),
            "x.csv: line 1: column troque_Nmm: unknown column; did you mean \"torque_Nmm\"?");
  EXPECT_EQ(table_refusal("angle_deg,current_A,humidity\n1.5,2.5,3.5\n"),
            "x.csv: line 1: column humidity: unknown column; there may be angle_deg, current_A, torque_Nmm");
  EXPECT_EQ(table_refusal("angle_deg,mood,current_A,humidity\n1.5,2,2.5,3.5\n"),
            "x.csv: line 1: columns mood, humidity: unknown columns; there may be angle_deg, current_A, torque_Nmm");
}

TEST(CsvTable, RefusesAnUnknownUnit) {
  EXPECT_EQ(
      table_refusal("angle_deg,current_mV\n1.5,2.5\n"),
      "x.csv: line 1: column current_mV: unknown unit; may be \"current_A\" or \"current_mA\", with the numbers in "
      "that unit");
  EXPECT_EQ(table_refusal("Angle_deg,current_A\n1.5,2.5\n"),
            "x.csv: line 1: column angle_deg: is missing; is \"Angle_deg\" meant? Every letter of a name counts");
  EXPECT_EQ(table_refusal("0,21.5\n1.5,2.5\n"),
            "x.csv: line 1: must name the columns, and has numbers only: the header is missing");
  EXPECT_EQ(table_refusal("angle_furlong,current_A\n1.5,2.5\n"), "x.csv: line 1: column angle_deg: is missing");
  EXPECT_EQ(
      table_refusal("angle,current_A\n1.5,2.5\n"),
      "x.csv: line 1: column angle: unknown unit; may be \"angle_rad\" or \"angle_mrad\" or \"angle_deg\", with the "
      "numbers in that unit");
  EXPECT_EQ(
      table_refusal("angle_deg,current_A,torque_deg\n1.5,2.5,3\n"),
      "x.csv: line 1: column torque_deg: unknown unit; may be \"torque_Nm\" or \"torque_Nmm\" or \"torque_mNm\" or "
      "\"torque_Ncm\" or .., with the numbers in that unit");
}

TEST(CsvTable, RefusesAColumnThatIsThereTwice) {
  EXPECT_EQ(table_refusal("angle_deg,current_A,angle_deg\n1,2,3\n"),
            "x.csv: line 1: column angle_deg: must not be there twice");
  EXPECT_EQ(table_refusal("angle_deg,current_A,angle_rad\n1,2,3\n"),
            "x.csv: line 1: column angle_rad: must not be there twice");
  EXPECT_EQ(table_refusal("angle_deg,current_A,\n1,2,3\n"), "x.csv: line 1: column 3: has no name");
  EXPECT_EQ(table_refusal(",angle_deg,current_A\n1,2,3\n"),
            "x.csv: line 1: column 1: has no name (a pandas index? write the file with index=False)");
}

TEST(CsvTable, RefusesWhatIsNoFiniteNumber) {
  const std::string header = "angle_deg,current_A\n1.5,2.5\n";
  const std::string place =
      "x.csv: line 3: column current_A: must be a finite number (delete the line if it is damaged); got ";
  for (const std::string field : {"abc", "inf", "-inf", "1e999", "1.5x", "0x10", "1 5", "+-2", "--2"}) {
    EXPECT_EQ(table_refusal(header + "3.5," + field + "\n"), place + "\"" + field + "\"");
  }
  for (const std::string field : {"", "nan", "NaN", "NA"})
    EXPECT_EQ(table_refusal(header + "3.5," + field + "\n"),
              "x.csv: line 3: column current_A: must be a finite number (delete the rows that have none); got \"" +
                  field + "\"");
  EXPECT_EQ(table_refusal(header + "3.5,\"a\nb\"\n"), place + "\"a\\nb\"");
}

TEST(CsvTable, RefusesARaggedRow) {
  EXPECT_EQ(table_refusal("angle_deg,current_A\n1.5,2.5\n3.5\n"),
            "x.csv: line 3: must have 2 fields, as the header has (delete the line if it is damaged); got 1");
  EXPECT_EQ(bench("angle_deg,current_A\n1.5,2.5,\n").rows(), 1u);  // a separator at the end
  EXPECT_EQ(table_refusal("angle_deg,current_A\n1,5,2,5\n"),
            "x.csv: line 2: must have 2 fields, as the header has (are its decimals written with commas?); got 4");
}

TEST(CsvTable, FindsSeparatorsAndDecimalSigns) {
  for (const std::string_view text :
       {"angle_deg;current_A\n1.5;2.5\n", "angle_deg;current_A\n1,5;2,5\n", "angle_deg\tcurrent_A\n1,5\t2,5\n",
        "angle_deg  current_A\n 1.5   2.5\n", "angle_deg|current_A\n1.5|2.5\n",
        "\"angle_deg\",\"current_A\"\n\"1,5\",\"2,5\"\n"})
    EXPECT_THAT(bench(text).column("current"), ElementsAre(2.5)) << text;
  EXPECT_THAT(table_refusal("frame|camera,angle_deg,current_A\n1,1.5,2.5\n"),
              StartsWith("x.csv: line 1: column frame|camera: unknown column"));
}

TEST(CsvTable, CountsLinesAcrossBlankOnesAndLineEndsInQuotes) {
  EXPECT_EQ(table_refusal("\nangle_deg,current_A\r\n\r\n1.5,2.5\r\nx,2\r\n"),
            "x.csv: line 5: column angle_deg: must be a finite number (delete the line if it is damaged); got \"x\"");
  EXPECT_EQ(
      table_refusal("angle_deg,current_A\n\"1.5\n\",2\n"),
      "x.csv: line 2: column angle_deg: must be a finite number (delete the line if it is damaged); got \"1.5\\n\"");
}

TEST(CsvTable, RefusesQuotesThatDoNotFit) {
  EXPECT_EQ(
      table_refusal("angle_deg,current_A\n1.5,2\"5\n"),
      "x.csv: line 2: must have quotes around whole fields only, and quotes inside them doubled (delete the line if it "
      "is damaged)");
  EXPECT_EQ(table_refusal("angle_deg,current_A\n1.5,\"2.5\n3.5,1\n"),
            "x.csv: line 2: must close the quote that it opens");
}

TEST(CsvTable, RefusesARowWithoutEnd) {
  EXPECT_EQ(table_refusal("angle_deg,current_A\n1.5,\"" + std::string(csv_row_limit, '\n')),
            "x.csv: line 2: must not be longer than 1 MB (is a quote not closed?)");
}

TEST(CsvTable, ChecksThatAColumnIncreases) {
  const CsvTable table = bench("angle_deg,current_A\n10,1.5\n20,2.5\n\n20,3.5\n15,4.5\n");
  EXPECT_EQ(testing::error_of([&] { table.require_increasing("current"); }), "accepted");
  EXPECT_EQ(
      testing::error_of([&] { table.require_increasing("angle"); }),
      "x.csv: line 6: column angle_deg: must exceed the value before it (20); the clock starts again here, so the "
      "file holds 2 records: make a file of each, with the line of names; got 15");
}

TEST(CsvTable, TellsAClockThatRunsBackwards) {
  const CsvTable table = bench("angle_deg,current_A\n0,1\n-1,2\n-2,3\n-3,4\n");
  EXPECT_EQ(testing::error_of([&] { table.require_increasing("angle"); }),
            "x.csv: line 3: column angle_deg: must exceed the value before it (0); the clock runs backwards: sort the "
            "rows by this column, or change its sign where that is wrong; got -1");
}

TEST(CsvTable, TellsACounterThatOverflowsFromAClockThatStartsAgain) {
  const auto read = [](std::string_view text) {
    const CsvTable table = parse_csv(text, "x.csv", [](CsvHeader& header) { header.require("time_us"); });
    return testing::error_of([&] { table.require_increasing("time"); });
  };
  EXPECT_EQ(read("time_us\n4294960000\n4294966000\n704\n"),
            "x.csv: line 4: column time_us: must exceed the value before it (4294966000); its counter of 32 bits began "
            "again: add 4294967296 to it from here on; got 704");
  EXPECT_THAT(read("time_us\n3294960000\n3294966000\n704\n"), ::testing::HasSubstr("the clock starts again here"));
}

TEST(CsvTable, ReadsTheExponentsOfFortran) {
  const CsvTable table = bench("angle_deg,current_A\n0.1D+02,-15D-1\n");
  EXPECT_EQ(table.column("current")[0], -1.5);
}

TEST(CsvTable, AllowsIgnoredColumnsButNotTextInThem) {
  const auto read = [](std::string_view text) {
    return parse_csv(text, "x.csv", [](CsvHeader& header) {
      header.require("time_s");
      header.ignore("theta#_deg");
    });
  };
  const CsvTable table = read("theta1_deg,time_s,theta2_rad\n1,2,3\n");
  EXPECT_THAT(table.column("time"), ElementsAre(2.0));
  EXPECT_THROW((void)table.column("theta1"), std::out_of_range);
  EXPECT_EQ(testing::error_of([&] { (void)read("time_s,theta1_deg\n1,x\n"); }),
            "x.csv: line 2: column theta1_deg: must be a finite number (delete the line if it is damaged); got \"x\"");
  EXPECT_EQ(testing::error_of([&] { (void)read("time_s,theta1_deg,theta3_deg\n1,2,3\n"); }),
            "x.csv: line 1: column theta3_deg: unknown column; did you mean \"theta2_deg\"?");
}

TEST(CsvTable, LeavesColumnsAloneWhateverIsInThem) {
  const auto read = [](std::string_view text) {
    const auto ask = [](CsvHeader& header) {
      EXPECT_THAT(header.absent(), ElementsAre("theta1_rad"));  // its whole name
      header.require("time_s");
      EXPECT_EQ(header.numbered("theta#_deg"), 0u);  // it counts as absent
    };
    return parse_csv(text, "x.csv", ask, {.ignore = {"#1", "theta1_deg", "theta1_rad"}});
  };
  const CsvTable table = read("note,time_s,theta1_deg\ndropped,2,x\n,3,\n");
  EXPECT_THAT(table.column("time"), ElementsAre(2.0, 3.0));
  EXPECT_THROW((void)table.column("theta1"), std::out_of_range);
  EXPECT_EQ(testing::error_of([&] { (void)read("note,time_s,theta1_deg\na,x,3\n"); }),
            "x.csv: line 2: column time_s: must be a finite number (delete the line if it is damaged); got \"x\"");
}

TEST(CsvTable, SkipsLinesThatBeginWithAHash) {
  EXPECT_THAT(bench("# logger 3, \"raw\r\n#\r\nangle_deg,current_A\r\n# x\n1.5,2.5\n#end").column("angle"),
              ElementsAre(::testing::DoubleEq(1.5 * 3.14159265358979323846 / 180.0)));
  // Only at the beginning of a line, and counted as a line.
  EXPECT_EQ(table_refusal("# a\nangle_deg,current_A\n1.5,#\n"),
            "x.csv: line 3: column current_A: must be a finite number (delete the line if it is damaged); got \"#\"");
  EXPECT_EQ(table_refusal("# a\n# b\n"), "x.csv: is empty: it must have a header");
}

TEST(CsvTable, TakesMillisecondsForSeconds) {
  const CsvTable table = parse_csv("time_ms\n1.5\n", "x.csv", [](CsvHeader& header) { header.require("time_s"); });
  EXPECT_THAT(table.column("time"), ElementsAre(1.5e-3));
  EXPECT_EQ(table.name("time"), "time_ms");
}

TEST(CsvTable, ReadsFilesLongerThanABlockWithoutLosingLineNumbers) {
  const TemporaryFolder folder;
  std::string text = "angle_deg,current_A\r\n";
  constexpr int rows = 30'000;
  for (int i = 0; i < rows; ++i) text += std::to_string(i) + "," + std::to_string(i + 0.25) + "\r\n";
  const auto good = folder.file("good.csv", text);
  const CsvTable table = read_csv(good, ask_for_bench);
  EXPECT_EQ(table.rows(), static_cast<std::size_t>(rows));
  EXPECT_EQ(table.column("current")[rows - 1], rows - 1 + 0.25);
  const auto bad = folder.file("bad.csv", text + "1,x\r\n");
  EXPECT_EQ(
      testing::error_of([&] { (void)read_csv(bad, ask_for_bench); }),
      bad.string() +
          ": line 30002: column current_A: must be a finite number (delete the line if it is damaged); got \"x\"");
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;  // sanitizers need memory of their own
#else
constexpr bool sanitized = false;
#endif

TEST(CsvTable, ReadsAFileOf100MegabytesInTheMemoryOfTheColumnsItKeeps) {
  const TemporaryFolder folder;
  const auto path = folder.file("large.csv", "");
  constexpr int blocks = 1000, rows_in_block = 1000;
  std::ofstream file(path, std::ios::binary);
  file << "angle_deg,current_A,theta1_deg,theta2_deg,theta3_deg,theta4_deg\n";
  std::string block;
  for (int i = 0; i < rows_in_block; ++i) {
    block += "12.3456789012345,0.7,12.3456789012345,12.3456789012345,12.3456789012345,12.3456789012345\n";
    block += "12.3,1.4,2,3,4,5\n";
  }
  for (int i = 0; i < blocks; ++i) file << block;
  file << "1,2,3,4,5,x\n";
  file.close();
  ASSERT_GT(std::filesystem::file_size(path), 100'000'000u);

  const auto peak_memory = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
  };
  const long before = peak_memory();
  EXPECT_EQ(
      testing::error_of([&] {
        (void)read_csv(path, [](CsvHeader& header) {
          ask_for_bench(header);
          header.ignore("theta#_deg");
        });
      }),
      path.string() +
          ": line 2000002: column theta4_deg: must be a finite number (delete the line if it is damaged); got \"x\"");
  // Two columns of 2 million doubles and the line of each row are 40 MB, a vector that grows holds up to 2.5 times
  // that.
  if (!sanitized) {
    EXPECT_LT(peak_memory() - before, 100'000'000);
  }
}

TEST(CsvTable, RefusesAFileBeyondTheSizeLimitBeforeReadingIt) {
  const TemporaryFolder folder;
  const auto large = folder.file("large.csv", "angle_deg");
  std::filesystem::resize_file(large, csv_size_limit + 1);  // sparse
  EXPECT_EQ(testing::error_of([&] { (void)read_csv(large, ask_for_bench); }),
            large.string() + ": must not be larger than 512 MB");
}

}  // namespace
}  // namespace coilwright::text

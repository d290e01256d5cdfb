#include "coilwright/text/json/document.hpp"

#include <gtest/gtest.h>

#include <string>

#include "temporary_folder.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::text {
namespace {

using coilwright::testing::TemporaryFolder;

std::string document_refusal(std::string_view text) {
  return testing::error_of([&] { (void)parse_json(text, "x.json"); });
}

TEST(JsonDocument, GivesValuesWithTheirPointers) {
  const Document document = parse_json(R"({"coil": {"radius_mm": 9.9, "a/b~c": [true, "x", null]}})", "x.json");
  const Node coil = document.root().find("coil").value();
  EXPECT_EQ(coil.find("radius_mm")->quantity(), 0.0099);
  const auto elements = coil.find("a/b~c")->elements();
  EXPECT_EQ(elements[1].pointer(), "/coil/a~1b~0c/1");
  EXPECT_TRUE(elements[0].boolean());
  EXPECT_EQ(elements[1].text(), "x");
  EXPECT_TRUE(elements[2].is_null());
}

TEST(JsonDocument, StaysValidWhenMoved) {
  Document first = parse_json(R"({"turns": 40})", "x.json");
  const Node turns = first.root().find("turns").value();
  const Document second = std::move(first);
  EXPECT_EQ(turns.integer(), 40);
  EXPECT_EQ(second.root().find("turns")->integer(), 40);
}

TEST(JsonDocument, SkipsAByteOrderMark) {
  EXPECT_EQ(parse_json("\xef\xbb\xbf{\"turns\": 40}", "x.json").root().find("turns")->integer(), 40);
  EXPECT_EQ(document_refusal("\xef\xbb\xbf[1,]"),
            "x.json: line 1, column 4: is not JSON: syntax error while parsing value - unexpected ']'; expected '[', "
            "'{', or a literal (a comma stands before it)");
}

TEST(JsonDocument, RefusesDuplicateKeys) {
  EXPECT_EQ(document_refusal(R"({"coils": [{"turns": 3}, {"turns": 4, "gap": 1, "turns": 5}]})"),
            "x.json: /coils/1/turns: duplicate key");
  EXPECT_EQ(document_refusal(R"({"a": 1, "\u0061": 2})"), "x.json: /a: duplicate key");
}

TEST(JsonDocument, AllowsOneKeyInDifferentObjects) {
  EXPECT_EQ(document_refusal(R"([{"a": {"a": 1}}, {"a": 2}])"), "accepted");
}

TEST(JsonDocument, RefusesNumbersThatAreNotFinite) {
  EXPECT_EQ(document_refusal(R"({"a": [1, 1e999]})"),
            "x.json: /a/1: must be a finite number (at most 1.8e308); got 1e999");
  EXPECT_EQ(document_refusal("-1e999"), "x.json: /: must be a finite number (at most 1.8e308); got -1e999");
  const std::string rule = "must be a finite number: JSON has no NaN and no Infinity";
  EXPECT_EQ(document_refusal("{\"a\":\n NaN}"), "x.json: line 2, column 2: " + rule);
  EXPECT_EQ(document_refusal("[2, Infinity]"), "x.json: line 1, column 5: " + rule);
  EXPECT_EQ(document_refusal("[2, -Infinity]"), "x.json: line 1, column 6: " + rule);
  EXPECT_EQ(document_refusal("[2, nan]"), "x.json: line 1, column 6: " + rule);
}

TEST(JsonDocument, RefusesATruncatedText) {
  EXPECT_EQ(document_refusal("{\"a\": [1,\n  2"), "x.json: line 2, column 4: ends before its JSON value is complete");
  EXPECT_EQ(document_refusal("{\"a\": \"te"), "x.json: line 1, column 10: ends before its JSON value is complete");
  EXPECT_EQ(document_refusal(""), "x.json: line 1, column 1: is empty: it must hold a JSON value");
}

TEST(JsonDocument, RefusesWhatIsNotJson) {
  EXPECT_EQ(document_refusal("radius = 3"),
            "x.json: line 1, column 1: is not JSON: syntax error while parsing value - invalid literal");
  EXPECT_EQ(document_refusal("{\"a\": 1,}"),
            "x.json: line 1, column 9: is not JSON: syntax error while parsing object key - unexpected '}'; "
            "expected string literal (a comma stands before it)");
  EXPECT_EQ(
      document_refusal("{\"mass_g\": 60,5}"),
      "x.json: line 1, column 15: is not JSON: syntax error while parsing object key - unexpected number literal; "
      "expected string literal (is a decimal written with a comma? JSON has a point)");
  EXPECT_EQ(document_refusal("{} {}"),
            "x.json: line 1, column 4: is not JSON: syntax error while parsing value - unexpected '{'; "
            "expected end of input");
  EXPECT_EQ(document_refusal("// no\n{}"),
            "x.json: line 1, column 1: is not JSON: syntax error while parsing value - invalid literal (JSON has no "
            "comments: "
            "write a text under the key \"comment\")");
}

TEST(JsonDocument, RefusesInvalidUtf8AndNulBytes) {
  EXPECT_EQ(document_refusal("[\"\xff\"]"),
            "x.json: line 1, column 3: is not JSON: syntax error while parsing value - invalid string: ill-formed "
            "UTF-8 byte");
  for (const std::string_view utf16 : {std::string_view("\xff\xfe{\0}\0", 6), std::string_view("\xfe\xff\0{\0}", 6),
                                       std::string_view("{\0}\0", 4), std::string_view("\0{\0}", 4)})
    EXPECT_EQ(
        document_refusal(utf16),
        "x.json: must be UTF-8, and is UTF-16: save it anew as UTF-8 (in an editor, or by iconv -f UTF-16 -t UTF-8)");
  EXPECT_EQ(document_refusal(std::string_view("{}\0{}", 5)), "x.json: line 1, column 3: is not JSON: holds a NUL byte");
}

TEST(JsonDocument, RefusesDeepNesting) {
  EXPECT_EQ(document_refusal(std::string(json_depth_limit, '[') + std::string(json_depth_limit, ']')), "accepted");
  const std::string deep(200'000, '[');
  std::string pointer;
  for (std::size_t i = 0; i < json_depth_limit; ++i) pointer += "/0";
  EXPECT_EQ(document_refusal(deep), "x.json: " + pointer + ": must be nested at most 64 deep");
}

TEST(JsonDocument, RefusesMoreValuesThanAnyStudyHas) {
  std::string many = "[0";
  for (std::size_t i = 0; i < json_value_limit; ++i) many += ",0";
  EXPECT_EQ(document_refusal(many + "]"), "x.json: /999999: must hold at most 1000000 values");
}

TEST(JsonDocument, NamesTheFileThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto refusal_of = [](const std::filesystem::path& path) {
    return testing::error_of([&] { (void)read_json(path); });
  };
  const auto absent = folder.path() / "x.json";
  EXPECT_EQ(refusal_of(absent), absent.string() + ": cannot be opened: No such file or directory");
  EXPECT_EQ(refusal_of(folder.path()), folder.path().string() + ": must be a file, and is a folder");
  EXPECT_EQ(refusal_of("/dev/zero"), "/dev/zero: must be a regular file, and is a device or a pipe");
  const auto under_file = folder.file("plain", "{}") / "x.json";
  EXPECT_EQ(refusal_of(under_file), under_file.string() + ": cannot be opened: Not a directory");
}

TEST(JsonDocument, RefusesALargeFileBeforeReadingIt) {
  const TemporaryFolder folder;
  const auto large = folder.file("large.json", "{");
  std::filesystem::resize_file(large, 100'000'000);  // sparse: no disk is filled, and reading it would meet NULs
  EXPECT_EQ(testing::error_of([&] { (void)read_json(large); }), large.string() + ": must not be larger than 16 MB");
}

TEST(JsonDocument, ReadsAFileOfManyBlocks) {
  const TemporaryFolder folder;
  std::string text = "[";
  for (int i = 0; i < 50'000; ++i) text += std::to_string(i) + ",";
  const auto file = folder.file("many.json", text + "-1]");
  EXPECT_EQ(read_json(file).root().elements().size(), 50'001u);
}

}  // namespace
}  // namespace coilwright::text

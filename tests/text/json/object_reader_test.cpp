#include "coilwright/text/json/object_reader.hpp"

#include <gtest/gtest.h>

#include <string>

#include "coilwright/text/json/document.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::text {
namespace {

enum class Shape { round, square };

struct Coil {
  double radius{};
  int turns{};
  Shape shape{};
  double pitch{};
};

Coil read_coil(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    return Coil{.radius = in.quantity("radius_mm", positive),
                .turns = in.integer("turns", Rule::at_least(1)),
                .shape = in.choice_or("shape", Shape::round, {{"round", Shape::round}, {"square", Shape::square}}),
                .pitch = in.quantity_or("pitch_mm", 0.35e-3, positive)};
  });
}

std::string coil_refusal(std::string_view coil) {
  const Document document = parse_json("{\"coil\": " + std::string(coil) + "}", "x.json");
  return testing::error_of([&] { (void)read_coil(document.root().find("coil").value()); });
}

/// Reads {"v_mm": value} with `read(node of v_mm)`.
template <class Read>
std::string refusal_of_value(std::string_view value, Read read) {
  const Document document = parse_json("{\"v_mm\": " + std::string(value) + "}", "x.json");
  return testing::error_of([&] { (void)read(document.root().find("v_mm").value()); });
}

TEST(ObjectReader, ReadsValuesInSiAndFillsInDefaults) {
  const Document document = parse_json(R"({"radius_mm": 9.9, "turns": 14, "shape": "square"})", "x.json");
  const Coil coil = read_coil(document.root());
  EXPECT_EQ(coil.radius, 0.0099);
  EXPECT_EQ(coil.turns, 14);
  EXPECT_EQ(coil.shape, Shape::square);
  EXPECT_EQ(coil.pitch, 0.35e-3);
}

TEST(ObjectReader, RefusesAnUnknownKeyAndSuggestsTheOneThatWasMeant) {
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 9.9, "turns": 14, "shpae": "round"})"),
            "x.json: /coil/shpae: unknown key; did you mean \"shape\"?");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 9.9, "turns": 14, "colour": "round"})"),
            "x.json: /coil/colour: unknown key; the keys here are \"pitch_mm\", \"radius_mm\", \"shape\", \"turns\"");
}

TEST(ObjectReader, AcceptsACommentInEveryObjectIfItIsAText) {
  EXPECT_EQ(coil_refusal(R"({"comment": "of the paper", "radius_mm": -9.9, "turns": 14})"),
            "x.json: /coil/radius_mm: must be > 0; got -9.9");
  EXPECT_EQ(coil_refusal(R"({"comment": 3, "radius_mm": 9.9, "turns": 14})"),
            "x.json: /coil/comment: must be a text; got 3");
  const Document document = parse_json(R"({"comment": "of the paper", "radius_mm": 9.9, "turns": 14})", "x.json");
  EXPECT_EQ(read_coil(document.root()).turns, 14);
}

TEST(ObjectReader, AcceptsTheSchemaOfAnEditorAtTheRootOnly) {
  const auto refusal_of_document = [](std::string_view text) {
    const Document document = parse_json(text, "x.json");
    return testing::error_of([&] { (void)read_coil(document.root()); });
  };
  const Document document = parse_json(R"({"$schema": "coil.json", "radius_mm": 9.9, "turns": 14})", "x.json");
  EXPECT_EQ(read_coil(document.root()).turns, 14);
  EXPECT_EQ(refusal_of_document(R"({"$schema": 3, "radius_mm": 9.9, "turns": 14})"),
            "x.json: /$schema: must be a text; got 3");
  EXPECT_EQ(coil_refusal(R"({"$schema": "coil.json", "radius_mm": 9.9, "turns": 14})"),
            "x.json: /coil/$schema: unknown key; the keys here are \"pitch_mm\", \"radius_mm\", \"shape\", \"turns\"");
}

TEST(ObjectReader, RefusesAWrongUnit) {
  EXPECT_EQ(coil_refusal(R"({"radius_m": 9.9, "turns": 14})"),
            "x.json: /coil/radius_m: unknown key; did you mean \"radius_mm\"?");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 9.9, "turns": 14, "pitch_um": 350})"),
            "x.json: /coil/pitch_um: unknown key; did you mean \"pitch_mm\"?");
  EXPECT_EQ(coil_refusal(R"({"radius": 9.9, "turns": 14})"),
            "x.json: /coil/radius: unknown key; did you mean \"radius_mm\"?");
}

TEST(ObjectReader, RefusesAMissingKey) {
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 9.9})"), "x.json: /coil/turns: is missing");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 9.9, "tuns": 14})"),
            "x.json: /coil/turns: is missing; is \"tuns\" meant to be it?");
}

TEST(ObjectReader, SaysWhatAMissingWordMayBe) {
  const auto refusal = [](const auto& read) {
    const Document document = parse_json(R"({"knd": "fit"})", "x.json");
    return testing::error_of([&] { read_object(document.root(), read); });
  };
  EXPECT_EQ(refusal([](ObjectReader& in) { in.literal("format", "study/1"); }),
            R"(x.json: /format: is missing: it must be "study/1")");
  EXPECT_EQ(refusal([](ObjectReader& in) {
              (void)in.choice<int>("kind", {{"fit", 0}, {"still", 1}});
            }),
            R"(x.json: /kind: is missing: it must be one of "fit", "still"; is "knd" meant to be it?)");
}

TEST(ObjectReader, RefusesAWrongTypeNamingBoth) {
  EXPECT_EQ(coil_refusal("[3]"), "x.json: /coil: must be an object; got an array of 1");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": "9.9"})"), "x.json: /coil/radius_mm: must be a number; got text \"9.9\"");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": null})"), "x.json: /coil/radius_mm: must be a number; got null");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 2, "turns": true})"),
            "x.json: /coil/turns: must be a whole number; got true");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 2, "turns": 3, "shape": {}})"),
            "x.json: /coil/shape: must be a text; got an object");
}

TEST(ObjectReader, RefusesANumberOutsideItsRule) {
  EXPECT_EQ(coil_refusal(R"({"radius_mm": -1.5})"), "x.json: /coil/radius_mm: must be > 0; got -1.5");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 2, "turns": 0})"), "x.json: /coil/turns: must be >= 1; got 0");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 2, "turns": 3.5})"), "x.json: /coil/turns: must be a whole number; got 3.5");
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 2, "turns": 3e9})"),
            "x.json: /coil/turns: must be from -2147483648 to 2147483647; got 3000000000");
}

TEST(ObjectReader, RefusesAWordThatIsNoChoice) {
  EXPECT_EQ(coil_refusal(R"({"radius_mm": 2, "turns": 3, "shape": "sqare"})"),
            "x.json: /coil/shape: must be one of \"round\", \"square\"; did you mean \"square\"?; got text \"sqare\"");
}

TEST(ObjectReader, TurnsACheckingConstructorsRefusalIntoAnInputError) {
  const Document document = parse_json(R"({"coil": {}})", "x.json");
  EXPECT_EQ(testing::error_of([&] {
              read_object(document.root().find("coil").value(),
                          [](ObjectReader&) -> int { throw std::invalid_argument("radius must be > 0; got 0"); });
            }),
            "x.json: /coil: radius must be > 0; got 0");
}

TEST(ObjectReader, WantsExactlyOneOfSeveralKeys) {
  const auto chosen = [](std::string_view text) {
    const Document document = parse_json(text, "x.json");
    return testing::error_of([&] { (void)ObjectReader(document.root()).one_of({"current_A", "voltage_V"}); });
  };
  EXPECT_EQ(chosen(R"({"voltage_V": 3})"), "accepted");
  EXPECT_EQ(chosen(R"({"voltage_V": 3, "current_A": 2})"), "x.json: /voltage_V: cannot stand beside \"current_A\"");
  EXPECT_EQ(chosen("{}"), "x.json: /: needs one of \"current_A\", \"voltage_V\"");
  EXPECT_EQ(chosen(R"({"curent_A": 1})"), "x.json: /curent_A: unknown key; did you mean \"current_A\"?");
  EXPECT_EQ(chosen(R"({"current_mA": 3})"), "x.json: /current_mA: unknown key; did you mean \"current_A\"?");
}

TEST(ObjectReader, ChecksALiteral) {
  const Document document = parse_json(R"({"format": "lumped-model/2"})", "x.json");
  ObjectReader reader(document.root());
  EXPECT_EQ(testing::error_of([&] { reader.literal("format", "lumped-model/1"); }),
            "x.json: /format: must be \"lumped-model/1\"; got text \"lumped-model/2\"");
}

TEST(ObjectReader, CountsNullAsAbsentOnlyWhereAsked) {
  const Document document = parse_json(R"({"magnetics": null})", "x.json");
  ObjectReader reader(document.root());
  EXPECT_TRUE(reader.find("magnetics"));
  EXPECT_FALSE(reader.find_not_null("magnetics"));
}

TEST(Node, ChecksArrayLengthsAndEveryElement) {
  EXPECT_EQ(refusal_of_value("[1, 2]", [](const Node& v) { return v.vector(); }),
            "x.json: /v_mm: must have 3 elements; got an array of 2");
  EXPECT_EQ(refusal_of_value("[1, 2, \"3\"]", [](const Node& v) { return v.vector(); }),
            "x.json: /v_mm/2: must be a number; got text \"3\"");
  EXPECT_EQ(refusal_of_value("[]", [](const Node& v) { return v.quantities(Length::at_least(2)); }),
            "x.json: /v_mm: must have at least 2 elements; got an array of 0");
  EXPECT_EQ(refusal_of_value("[1,2,3]", [](const Node& v) { return v.elements(Length::from_to(1, 2)); }),
            "x.json: /v_mm: must have 1 to 2 elements; got an array of 3");
  EXPECT_EQ(refusal_of_value("7", [](const Node& v) { return v.elements(); }),
            "x.json: /v_mm: must be an array; got 7");
}

TEST(Node, ConvertsEveryElementOfAnArrayByItsKeysUnit) {
  const Document document = parse_json(R"({"position_mm": [9.9, -4.35, 0.1], "axis": [0.6, 0, 0.8]})", "x.json");
  EXPECT_EQ(document.root().find("position_mm")->vector(), (std::array{0.0099, -0.00435, 0.0001}));
  EXPECT_EQ(document.root().find("position_mm")->numbers(), (std::vector{9.9, -4.35, 0.1}));
  EXPECT_EQ(document.root().find("axis")->vector(), (std::array{0.6, 0.0, 0.8}));
}

TEST(Node, GivesMembersByNameAndNumbersInTheUnitOfThatName) {
  const Document document = parse_json(R"({"gap_mm": {"lower": 9.9}, "base_tilt_deg": {"lower": 90}})", "x.json");
  const auto members = document.root().members();
  ASSERT_EQ(members.size(), 2u);
  EXPECT_EQ(members[0].key(), "gap_mm");
  EXPECT_EQ(members[1].pointer(), "/base_tilt_deg");
  EXPECT_EQ(members[0].find("lower")->quantity_in(units::split_unit(members[0].key())->unit), 0.0099);
}

TEST(ObjectReader, ReadsTruthValuesAndTextsOrTheirDefaults) {
  const Document document = parse_json(R"({"on": true, "name": "B", "bad": 1})", "x.json");
  ObjectReader reader(document.root());
  EXPECT_TRUE(reader.at("on").boolean());
  EXPECT_EQ(reader.text_or("name", "A"), "B");
  EXPECT_EQ(reader.text_or("absent", "A"), "A");
  EXPECT_EQ(testing::error_of([&] { (void)reader.at("bad").boolean(); }), "x.json: /bad: must be true or false; got 1");
  EXPECT_EQ(testing::error_of([&] { (void)reader.text("bad"); }), "x.json: /bad: must be a text; got 1");
}

TEST(Node, StatesEveryKindOfInterval) {
  const auto refused = [](const Rule& rule) {
    return refusal_of_value("7.25", [&](const Node& v) { return v.number(rule); });
  };
  EXPECT_EQ(refused(Rule::between(2, 5)), "x.json: /v_mm: must be from 2 to 5; got 7.25");
  EXPECT_EQ(refused(Rule::at_most(5)), "x.json: /v_mm: must be <= 5; got 7.25");
  EXPECT_EQ(refused(Rule::below(7.25)), "x.json: /v_mm: must be < 7.25; got 7.25");
  EXPECT_EQ(refused(positive.and_also(Rule::at_most(1))), "x.json: /v_mm: must be > 0 and <= 1; got 7.25");
  EXPECT_EQ(refused(Rule::at_least(7.25)), "accepted");
}

TEST(Node, ResolvesPathsFromTheFolderOfTheFile) {
  const Document document =
      parse_json(R"({"a": "../actuators/x.json", "b": "/etc/x.json", "c": ""})", "configs/s/study.json");
  EXPECT_EQ(document.root().find("a")->path(), "configs/s/../actuators/x.json");
  EXPECT_EQ(document.root().find("b")->path(), "/etc/x.json");
  EXPECT_EQ(testing::error_of([&] { (void)document.root().find("c")->path(); }),
            "configs/s/study.json: /c: must be a path; got text \"\"");
}

TEST(Node, RefusesANameThatATerminalATableOrTheSystemTakesForSomethingElse) {
  const Document document = parse_json(
      R"({"good": "Finger 3, \u00b1 5 \u00b0C", "nul": "a\u0000.csv", "line": "a\nb", "escape": "\u001b[31m", "formula": "=1+1"})",
      "x.json");
  const auto at = [&](const char* key) { return *document.root().find(key); };
  EXPECT_EQ(at("good").name(), "Finger 3, \u00b1 5 \u00b0C");
  for (const auto& [key, shown] :
       {std::pair("nul", R"(a\x00.csv)"), std::pair("line", R"(a\nb)"), std::pair("escape", R"(\x1b[31m)")}) {
    const std::string message =
        std::string("x.json: /") + key + ": must be one line without control characters; got text \"" + shown + '"';
    EXPECT_EQ(testing::error_of([&] { (void)at(key).name(); }), message);
    EXPECT_EQ(testing::error_of([&] { (void)at(key).path(); }), message);
  }
  EXPECT_EQ(
      testing::error_of([&] { (void)at("formula").name(); }),
      R"(x.json: /formula: must not begin with "=" or "@": a spreadsheet takes it for a formula; got text "=1+1")");
}

TEST(Node, ReadsLargeSeedsExactlyAndRefusesThoseADoubleCannotHold) {
  const Document document = parse_json(R"({"seed": 9007199254740991, "large": 9007199254740994})", "x.json");
  EXPECT_EQ(document.root().find("seed")->integer<std::uint64_t>(), 9007199254740991u);
  EXPECT_EQ(testing::error_of([&] { (void)document.root().find("large")->integer<std::uint64_t>(); }),
            "x.json: /large: must be from 0 to 9007199254740992; got 9007199254740994");
}

}  // namespace
}  // namespace coilwright::text

// The readers against damaged files: whatever the damage, the answer is a value or one line of InputError. The fuzzers
// in tests/fuzz go further; this part of them runs everywhere, and always the same.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <utility>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/pair_file.hpp"
#include "coilwright/formats/data/dataset_file.hpp"
#include "coilwright/formats/data/experiment_file.hpp"
#include "coilwright/formats/data/run_file.hpp"
#include "coilwright/formats/simulation/commanded_input_file.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using Read = std::function<void(const std::string& text)>;

void read_as_pair(const std::string& text) {
  (void)parse_pair(text, "x");
}
void read_as_actuator(const std::string& text) {
  (void)parse_actuator(text, "x");
}
// Beside the actuator that it names, so that an undamaged study is read to its end.
void read_as_study(const std::string& text) {
  (void)parse_study(text, COILWRIGHT_TEST_DATA "/formats/x");
}
void read_as_experiment(const std::string& text) {
  (void)parse_experiment(text, COILWRIGHT_TEST_DATA "/formats/x");
}
// Beside the runs that it names, so that an undamaged set is read to its end.
void read_as_dataset(const std::string& text) {
  (void)parse_dataset(text, COILWRIGHT_TEST_DATA "/formats/dataset/x");
}
Read read_as_run(measurement::data::RunKind kind) {
  return [kind](const std::string& text) { (void)parse_run(text, "x", {.name = "x", .kind = kind, .sigma = 0.3}); };
}
void read_as_signal(const std::string& text) {
  (void)parse_commanded_input(text, "x");
}

std::string load(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(COILWRIGHT_TEST_DATA "/formats/" + name, std::ios::binary).rdbuf();
  return text.str();
}

/// True when the text was accepted. Any exception but InputError fails the test.
bool accepts(const Read& read, const std::string& text) {
  try {
    read(text);
    return true;
  } catch (const InputError& error) {
    const std::string_view line = error.what();
    EXPECT_TRUE(line.starts_with("x: ") || line.starts_with(COILWRIGHT_TEST_DATA)) << line;
    EXPECT_EQ(line.find_first_of("\n\r"), std::string_view::npos) << line;
    return false;
  }
}

void damage_at_every_byte(const Read& read, const std::string& text) {
  std::mt19937 random(20240311);  // any fixed seed
  const std::string telling = "\"\\{}[],:-+.eE09 \n\r\t\0\x7f\x80\xff\xc3";
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string flipped = text, replaced = text, doubled = text, removed = text;
    flipped[i] = static_cast<char>(flipped[i] ^ (1 << (random() % 8)));
    replaced[i] = telling[random() % telling.size()];
    doubled.insert(i, text, i, 1 + random() % 20);
    removed.erase(i, 1 + random() % 5);
    for (const std::string& damaged : {flipped, replaced, doubled, removed}) accepts(read, damaged);
  }
}

TEST(DamagedFiles, EveryTruncationOfAPairIsRefused) {
  for (const std::string name : {"pair.json", "two_coils.json", "two_magnets.json"}) {
    const std::string text = load(name);
    ASSERT_TRUE(accepts(read_as_pair, text));
    const std::size_t end = text.rfind('}');
    for (std::size_t size = 0; size <= end; ++size) EXPECT_FALSE(accepts(read_as_pair, text.substr(0, size))) << size;
  }
}

TEST(DamagedFiles, OfAPairNeverDoMoreThanBeRefused) {
  for (const std::string name : {"pair.json", "two_coils.json", "two_magnets.json"}) {
    damage_at_every_byte(read_as_pair, load(name));
  }
}

TEST(DamagedFiles, EveryTruncationOfAnActuatorOrAStudyIsRefused) {
  for (const auto& [name, read] : {std::pair<std::string, Read>{"actuator.json", read_as_actuator},
                                   {"lumped_model.json", read_as_actuator},
                                   {"study.json", read_as_study}}) {
    const std::string text = load(name);
    ASSERT_TRUE(accepts(read, text)) << name;
    const std::size_t end = text.rfind('}');
    for (std::size_t size = 0; size <= end; ++size) EXPECT_FALSE(accepts(read, text.substr(0, size))) << name << size;
  }
}

TEST(DamagedFiles, OfActuatorsAndStudiesNeverDoMoreThanBeRefused) {
  damage_at_every_byte(read_as_actuator, load("actuator.json"));
  damage_at_every_byte(read_as_actuator, load("lumped_model.json"));
  damage_at_every_byte(read_as_study, load("study.json"));
}

TEST(DamagedFiles, OfAnExperimentNeverDoMoreThanBeRefused) {
  const std::string text = load("experiment.json");
  ASSERT_TRUE(accepts(read_as_experiment, text));
  for (std::size_t size = 0; size <= text.rfind('}'); ++size)
    EXPECT_FALSE(accepts(read_as_experiment, text.substr(0, size))) << size;
  damage_at_every_byte(read_as_experiment, text);
}

TEST(DamagedFiles, OfACommandedInputNeverDoMoreThanBeRefused) {
  const std::string text = load("input.csv");
  ASSERT_TRUE(accepts(read_as_signal, text));
  for (std::size_t size = 0; size < text.size(); ++size) accepts(read_as_signal, text.substr(0, size));
  damage_at_every_byte(read_as_signal, text);
}

TEST(DamagedFiles, OfADatasetNeverDoMoreThanBeRefused) {
  const std::string text = load("dataset/dataset.json");
  ASSERT_TRUE(accepts(read_as_dataset, text));
  const std::size_t end = text.rfind('}');
  for (std::size_t size = 0; size <= end; ++size) EXPECT_FALSE(accepts(read_as_dataset, text.substr(0, size))) << size;
  damage_at_every_byte(read_as_dataset, text);
}

TEST(DamagedFiles, OfARunNeverDoMoreThanBeRefused) {
  using enum measurement::data::RunKind;
  for (const auto& [name, kind] :
       {std::pair{"dataset/step.csv", transient}, std::pair{"dataset/swing.csv", transient},
        std::pair{"dataset/bench.csv", static_torque}, std::pair{"dataset/wall.csv", blocked_force}}) {
    const std::string text = load(name);
    const Read read = read_as_run(kind);
    ASSERT_TRUE(accepts(read, text)) << name;
    for (std::size_t size = 0; size < text.size(); ++size) accepts(read, text.substr(0, size));
    damage_at_every_byte(read, text);
  }
}

TEST(DamagedFiles, OfRandomBytesNeverDoMoreThanBeRefused) {
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string text(random() % 200, '\0');
    for (char& c : text) c = static_cast<char>(random());
    EXPECT_FALSE(accepts(read_as_pair, text));
    EXPECT_FALSE(accepts(read_as_signal, text));
  }
}

}  // namespace
}  // namespace coilwright::formats

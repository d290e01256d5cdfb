#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "coilwright/text/output/file_name.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "temporary_folder.hpp"

namespace {
int renames_before_death = -1;  // none
}

// In place of the system's: a kill between two names.
extern "C" int rename(const char* from, const char* to) noexcept {
  if (renames_before_death == 0) _exit(9);
  --renames_before_death;
  return renameat(AT_FDCWD, from, AT_FDCWD, to);
}

namespace coilwright::text {
namespace {

namespace fs = std::filesystem;
using coilwright::testing::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// What can be written to a file while it lives: the stand-in for a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    before_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, before_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*before_handler_)(int){};
};

TEST(OutputFile, KnowsAFileOfItsOwnKindByItsBeginning) {
  const TemporaryFolder folder;
  const auto replaces_other = [&](const std::string& present, const std::string& written, std::string_view mark) {
    OutputFile file(folder.file("x", present));
    file.stream() << written;
    return file.would_replace_other_kind(mark);
  };
  EXPECT_FALSE(replaces_other("time_s,x\n0,1\n", "time_s,x\n0,2\n", "\n"));
  EXPECT_TRUE(replaces_other("time_s,y\n0,1\n", "time_s,x\n0,2\n", "\n"));
  EXPECT_TRUE(replaces_other("time", "time_s,x\n0,2\n", "\n"));
  EXPECT_FALSE(replaces_other("", "time_s,x\n0,2\n", "\n"));
  EXPECT_FALSE(replaces_other("{\"format\": 1, 2}", "{\"format\": 1, 3}", ", "));
  EXPECT_TRUE(replaces_other("{\"format\": 2, 2}", "{\"format\": 1, 3}", ", "));
  // No mark at all: only the same whole content is of its kind.
  EXPECT_TRUE(replaces_other("notes", "other", "\n"));
  OutputFile alone(folder.path() / "new");
  alone.stream() << "anything\n";
  EXPECT_FALSE(alone.would_replace_other_kind("\n"));
}

TEST(OutputFile, ReplacesWhatStoodThereOnlyOnCommit) {
  const TemporaryFolder folder;
  const auto path = folder.file("x.csv", "before");
  {
    OutputFile file(path);
    file.stream() << "after";
    file.stream().flush();
    EXPECT_EQ(content(path), "before");
    file.commit();
  }
  EXPECT_EQ(content(path), "after");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("x.csv"));
}

TEST(OutputFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  { OutputFile(folder.path() / "x.csv").stream() << "half"; }
  EXPECT_THAT(names_in(folder.path()), IsEmpty());
}

TEST(OutputFile, RemovesWhatAKilledWriterLeftAndKeepsWhatALivingOneWrites) {
  const TemporaryFolder folder;
  const auto path = folder.file("x.csv", "before");
  for (const char* name : {".x.csv.part-1", ".x.csv.part-mine", ".y.csv.part-1"}) folder.file(name, "half");
  OutputFile file(path);
  file.stream() << "after";
  remove_left_parts(path);  // another writer of the same file
  EXPECT_THAT(names_in(folder.path()),
              ElementsAre(".x.csv.part-" + std::to_string(getpid()), ".x.csv.part-mine", ".y.csv.part-1", "x.csv"));
  file.commit();
  EXPECT_EQ(content(path), "after");
}

TEST(OutputFile, WritesThroughNoLinkInThePlaceOfItsSibling) {
  const TemporaryFolder folder;
  const auto other = folder.file("other", "mine");
  fs::create_symlink("other", folder.path() / (".x.csv.part-" + std::to_string(getpid())));
  EXPECT_THAT([&] { const OutputFile file(folder.path() / "x.csv"); },
              ThrowsMessage<OutputError>((folder.path() / "x.csv").string() + ": cannot be written: File exists"));
  EXPECT_EQ(content(other), "mine");
}

TEST(OutputFile, FollowsALinkAndKeepsIt) {
  const TemporaryFolder folder;
  const auto target = folder.file("target.csv", "before");
  fs::create_symlink("target.csv", folder.path() / "link.csv");
  OutputFile file(folder.path() / "link.csv");
  file.stream() << "after";
  file.commit();
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.csv"));
  EXPECT_EQ(content(target), "after");
}

TEST(OutputFile, RefusesAPlaceThatCannotBeWrittenBeforeTheWork) {
  const TemporaryFolder folder;
  const auto refused = [](const fs::path& path) { return [path] { const OutputFile file(path); }; };
  const auto absent = folder.path() / "no" / "x.csv";
  EXPECT_THAT(refused(absent),
              ThrowsMessage<OutputError>(absent.string() + ": cannot be written: No such file or directory"));
  EXPECT_THAT(refused(folder.path()),
              ThrowsMessage<OutputError>(folder.path().string() + ": cannot be written: Is a directory"));
  EXPECT_THAT(refused("/dev/null"),
              ThrowsMessage<OutputError>("/dev/null: cannot be written: it is a device or a pipe"));
}

TEST(OutputFile, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const auto path = folder.file("x.csv", "before");
  {
    OutputFile file(path);
    const FileSizeLimit limit(10'000);
    try {
      file.stream() << std::string(200'000, 'x');
      FAIL() << "a file beyond the limit was written";
    } catch (const OutputError& error) {
      EXPECT_EQ(error.what(), path.string() + ": cannot be written: File too large");
      EXPECT_EQ(error.stage(), OutputError::Stage::writing);
    }
  }
  EXPECT_EQ(content(path), "before");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("x.csv"));
}

// A stream takes what its buffer throws meanwhile for a source that has ended.
TEST(OutputFile, TellsOfAFullDiskWhereAFileIsCopiedIntoItAsAWhole) {
  const TemporaryFolder folder;
  std::ifstream source(folder.file("long.csv", std::string(200'000, 'x')));
  OutputFile file(folder.path() / "copy.csv");
  const FileSizeLimit limit(10'000);
  EXPECT_THAT([&] { file.stream() << source.rdbuf(); },
              ThrowsMessage<OutputError>(file.path().string() + ": cannot be written: File too large"));
}

TEST(OutputFolder, ShowsItsFilesTogetherOnCommitAndKeepsOthers) {
  const TemporaryFolder folder;
  folder.file("front.csv", "before");
  folder.file("notes.txt", "mine");
  OutputFolder out(folder.path());
  out.open("front.csv") << "after";
  out.write("result.json", "{}\n");
  EXPECT_EQ(content(folder.path() / "front.csv"), "before");
  EXPECT_FALSE(fs::exists(folder.path() / "result.json"));
  out.commit();
  EXPECT_EQ(content(folder.path() / "front.csv"), "after");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("front.csv", "notes.txt", "result.json"));
}

TEST(OutputFolder, HasNeverFilesOfTwoAnswersWhereItIsKilledAndItsKeyOnlyWithAllOthers) {
  const auto write = [](const fs::path& folder, int renames) {
    OutputFolder out(folder);
    for (const char* name : {"result.json", "a.csv", "b.csv"}) out.write(name, "after");
    renames_before_death = renames;
    out.commit("result.json");
  };
  for (int renames = 0; renames < 3; ++renames) {
    const TemporaryFolder folder;
    for (const char* name : {"result.json", "a.csv", "b.csv"}) folder.file(name, "before");
    EXPECT_EXIT(write(folder.path(), renames), ::testing::ExitedWithCode(9), "");
    for (const std::string& name : names_in(folder.path())) EXPECT_EQ(content(folder.path() / name), "after") << name;
    EXPECT_EQ(fs::exists(folder.path() / "a.csv"), renames > 0);
    EXPECT_FALSE(fs::exists(folder.path() / "result.json"));
    write(folder.path(), -1);  // the next one has what is left removed
    EXPECT_THAT(names_in(folder.path()), ElementsAre("a.csv", "b.csv", "result.json"));
  }
}

TEST(OutputFolder, RemovesAnOutdatedResultOnCommitOnly) {
  const TemporaryFolder folder;
  folder.file("actuator.json", "of an earlier run");
  {
    OutputFolder out(folder.path());
    out.remove("actuator.json");
  }
  EXPECT_EQ(content(folder.path() / "actuator.json"), "of an earlier run");
  OutputFolder out(folder.path());
  out.remove("actuator.json");
  out.remove("never_there.json");
  out.write("result.json", "{}\n");
  EXPECT_THROW(out.remove("../notes.txt"), std::invalid_argument);
  out.commit();
  EXPECT_THAT(names_in(folder.path()), ElementsAre("result.json"));
}

TEST(OutputFolder, RemovesNothingThatItWritesAgain) {
  const TemporaryFolder folder;
  folder.file("elsewhere.json", "before");
  fs::create_symlink("elsewhere.json", folder.path() / "result.json");
  OutputFolder out(folder.path());
  out.remove("result.json");
  out.write("result.json", "after");
  EXPECT_TRUE(out.has("result.json"));
  EXPECT_FALSE(out.is_unchanged("result.json"));
  out.commit("result.json");
  EXPECT_EQ(content(folder.path() / "elsewhere.json"), "after");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "result.json"));
  out.write("result.json", "after");
  EXPECT_TRUE(out.is_unchanged("result.json"));
  EXPECT_FALSE(out.has("other.json"));
  EXPECT_FALSE(out.is_unchanged("other.json"));
}

TEST(OutputFolder, LeavesNoFolderThatItMadeWithoutCommit) {
  const TemporaryFolder folder;
  {
    OutputFolder out(folder.path() / "a" / "b");
    out.write("x.csv", "x");
    EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
  }
  EXPECT_THAT(names_in(folder.path()), IsEmpty());
}

TEST(OutputFolder, MakesFoldersAndKeepsThemOnCommit) {
  const TemporaryFolder folder;
  OutputFolder out(folder.path() / "a" / "b" / "");
  out.write("x.csv", "x");
  out.commit();
  EXPECT_EQ(content(folder.path() / "a" / "b" / "x.csv"), "x");
}

// Thousands of folders took half a minute to make and to take away.
TEST(OutputFolder, RefusesAPathOfManyNewFoldersAndMakesNone) {
  const TemporaryFolder folder;
  for (const int depth : {100, 2100}) {
    fs::path path = folder.path();
    for (int i = 0; i < depth; ++i) path /= "a";
    if (depth > 100)
      EXPECT_THROW(OutputFolder{path}, OutputError);
    else
      EXPECT_NO_THROW(OutputFolder{path});
    EXPECT_FALSE(fs::exists(folder.path() / "a"));
  }
}

TEST(OutputFolder, RefusesAPlaceThatCannotBeWrittenBeforeTheWork) {
  const TemporaryFolder folder;
  const auto file = folder.file("plain", "x");
  EXPECT_THAT([&] { const OutputFolder out(file / "out"); },
              ThrowsMessage<OutputError>((file / "out").string() + ": cannot be written: Not a directory"));
  EXPECT_THAT([&] { const OutputFolder out(file); },
              ThrowsMessage<OutputError>(file.string() + ": cannot be written: Not a directory"));
  EXPECT_THAT([&] { const OutputFolder out(""); },
              ThrowsMessage<OutputError>(": cannot be written: the name of the folder must not be empty"));
}

TEST(OutputFolder, ChangesNoFileWhenOneIsIncomplete) {
  const TemporaryFolder folder;
  folder.file("a.csv", "before");
  OutputFolder out(folder.path());
  out.open("a.csv") << "after";
  const FileSizeLimit limit(500);
  out.open("b.csv") << std::string(900, 'x');  // still in the buffer: only closing meets the limit
  EXPECT_THROW(out.commit(), OutputError);
  EXPECT_EQ(content(folder.path() / "a.csv"), "before");
}

TEST(OutputFolder, RefusesNamesOutsideItselfAndASecondOpening) {
  const TemporaryFolder folder;
  OutputFolder out(folder.path());
  EXPECT_THAT([&] { out.write("../x.csv", ""); },
              ThrowsMessage<std::invalid_argument>("name must be a plain file name; got ../x.csv"));
  out.write("x.csv", "");
  EXPECT_THAT([&] { out.write("x.csv", ""); },
              ThrowsMessage<std::invalid_argument>("name must not be opened twice; got x.csv"));
}

TEST(FileNames, ArePlainAndDifferByMoreThanCapitals) {
  for (const char* name : {"x", "x.csv", "..x", "x..", "-", " ", "\u00e4.csv"})
    EXPECT_FALSE(fault_of_file_name(name)) << name;
  for (const char* name : {"", ".", "..", "/x", "a/b", "../x", "a\\b"})
    EXPECT_EQ(fault_of_file_name(name), "must be a plain file name") << name;
  for (const std::string& name :
       {std::string("a\nb"), std::string("a\tb"), std::string("\x1b[1m"), std::string("a\0b", 3)})
    EXPECT_EQ(fault_of_file_name(name), "must be one line without control characters");
  EXPECT_EQ(fault_of_file_name(std::string(256, 'x')), "must have at most 255 bytes");
  using Names = std::vector<std::string>;
  EXPECT_FALSE(fault_of_file_names(Names{"a", "b", "a.csv"}));
  EXPECT_EQ(fault_of_file_names(Names{"a", "b", "a"})->index, 2U);
  EXPECT_EQ(fault_of_file_names(Names{"a", "b/c", "a"})->index, 1U);
  EXPECT_EQ(fault_of_file_names(Names{"Step.csv", "step.csv"})->rule,
            "must differ from \"Step.csv\" by more than capitals: on many systems they are one file");
}

}  // namespace
}  // namespace coilwright::text

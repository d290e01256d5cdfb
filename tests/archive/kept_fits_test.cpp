// Fits that are kept in an archive: found again by whoever opens it, and never once a byte of them has changed.
#include "coilwright/archive/kept_fits.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <string>

#include "coilwright/archive/reader.hpp"
#include "coilwright/archive/writer.hpp"
#include "temporary_folder.hpp"

namespace coilwright::archive {
namespace {

class KeptFitsTest : public ::testing::Test {
 protected:
  KeptFitsTest() { create(path_, {.command = "diagnose", .seed = 1}); }

  // Changes the file as another program would.
  void change(const std::string& sql) const {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
    EXPECT_GT(sqlite3_changes(database), 0);
    sqlite3_close(database);
  }

  testing::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "archive.sqlite";
  const std::string bytes_ = std::string(100'000, '\0');
};

TEST_F(KeptFitsTest, AreFoundAgainByWhoeverOpensThem) {
  open_fits(path_, {}).keep("asked", bytes_);
  {
    const KeptFits again = open_fits(path_, {});
    EXPECT_EQ(again.recall("asked"), bytes_);
    EXPECT_EQ(again.recall("another"), std::nullopt);
  }
  EXPECT_EQ(Reader(path_).contents().command, "diagnose");
}

TEST_F(KeptFitsTest, DoNotAnswerOnceAByteHasChanged) {
  open_fits(path_, {}).keep("asked", bytes_);
  change("UPDATE fits SET found = CAST('b' || substr(found, 2) AS BLOB)");
  EXPECT_EQ(open_fits(path_, {}).recall("asked"), std::nullopt);
  open_fits(path_, {}).keep("asked", bytes_);
  EXPECT_EQ(open_fits(path_, {}).recall("asked"), bytes_);
  change("UPDATE fits SET asked = 'another'");
  EXPECT_EQ(open_fits(path_, {}).recall("another"), std::nullopt);
}

TEST_F(KeptFitsTest, AreKeptNoMoreOnceTheDiskHasRefusedTwoInARow) {
  int told = 0;
  std::string line;
  KeptFits fits = open_fits(path_, [&](const std::string& text) {
    ++told;
    line = text;
  });
  const std::string refused(100'000'001, '\0');  // SQLite takes no value as large
  fits.keep("first", refused);
  EXPECT_EQ(told, 0);
  fits.keep("second", bytes_);
  fits.keep("third", refused);
  fits.keep("third", refused);
  EXPECT_EQ(told, 1);
  EXPECT_EQ(line, path_.string() + ": cannot be written: string or blob too big");
  fits.keep("fourth", bytes_);
  EXPECT_EQ(fits.recall("second"), std::nullopt);  // nor is anything waited for
  fits = {};
  const KeptFits again = open_fits(path_, {});
  EXPECT_EQ(again.recall("second"), bytes_);
  EXPECT_EQ(again.recall("fourth"), std::nullopt);
}

}  // namespace
}  // namespace coilwright::archive

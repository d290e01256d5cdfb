#include "coilwright/text/opened_file.hpp"

#include <gmock/gmock.h>

#include <sstream>
#include <string>

#include "coilwright/text/input_error.hpp"
#include "temporary_folder.hpp"

namespace coilwright::text {
namespace {

using ::testing::ThrowsMessage;

std::string rest_of(const std::filesystem::path& path, std::size_t without = 0) {
  std::ifstream file = opened(path);
  file.ignore(static_cast<std::streamsize>(without));
  std::ostringstream copy;
  copy_rest(file, path, copy);
  return copy.str();
}

TEST(OpenedFile, IsCopiedFromWhereItWasReadToItsEnd) {
  const TemporaryFolder folder;
  const std::string text(200'000, 'x');
  EXPECT_EQ(rest_of(folder.file("long.csv", "header\n" + text), 7), text);
  EXPECT_EQ(rest_of(folder.file("short.csv", "header\n"), 7), "");
  EXPECT_EQ(rest_of(folder.file("empty.csv", "")), "");
}

TEST(OpenedFile, ThatCannotBeOpenedOrReadIsNoEmptyOne) {
  const TemporaryFolder folder;
  const std::filesystem::path none = folder.path() / "none.csv";
  EXPECT_THAT([&] { rest_of(none); },
              ThrowsMessage<InputError>(none.string() + ": cannot be opened: No such file or directory"));
  EXPECT_THAT([&] { rest_of(folder.path()); },
              ThrowsMessage<InputError>(folder.path().string() + ": cannot be read: Is a directory"));
}

}  // namespace
}  // namespace coilwright::text

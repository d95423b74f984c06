// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/file_io.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using support::read_text;
using support::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

mode_t mode_of(const std::string& file) {
  struct stat status {};
  EXPECT_EQ(::stat(file.c_str(), &status), 0);
  return status.st_mode & 07777;
}

TEST(ReadFile, GivesTheBytesAsTheyAre) {
  const TemporaryFolder folder;
  const std::string bytes("L1=Y2\r\n\0\xFF", 9);
  EXPECT_EQ(read_file(folder.write("Деталь 1.bgt", bytes)).value(), bytes);
}

TEST(ReadFile, AMissingFileOrAFolderIsAnErrorWithItsName) {
  const TemporaryFolder folder;
  const auto missing = read_file(folder.name("no.bgt"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().error, ENOENT);
  EXPECT_EQ(missing.error().text(), folder.name("no.bgt") + ": No such file or directory");
  const auto a_folder = read_file(folder.path());
  ASSERT_FALSE(a_folder);
  EXPECT_EQ(a_folder.error().error, EISDIR);
}

TEST(WriteFile, MakesAFileOrReplacesItAndLeavesNothingElse) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder.name("Деталь.nc"), "first"));
  EXPECT_EQ(read_text(folder.name("Деталь.nc")), "first");
  ASSERT_TRUE(write_file(folder.name("Деталь.nc"), "2"));
  EXPECT_EQ(read_text(folder.name("Деталь.nc")), "2");
  EXPECT_THAT(folder.entries(), ElementsAre("Деталь.nc"));
}

TEST(WriteFile, ANewFileHasThePermissionsOfTheUsersMask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  ASSERT_TRUE(write_file(folder.name("a.nc"), "x"));
  ::umask(before);
  EXPECT_EQ(mode_of(folder.name("a.nc")), 0640U);
}

TEST(WriteFile, AReplacedFileKeepsItsPermissions) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.nc", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0604), 0);
  ASSERT_TRUE(write_file(file, "new"));
  EXPECT_EQ(mode_of(file), 0604U);
}

TEST(WriteFile, ALinkStaysALinkAndItsTargetIsWritten) {
  const TemporaryFolder folder;
  const std::string target = folder.write("parts/a.nc", "old");
  fs::create_symlink("parts/a.nc", folder.name("link.nc"));
  ASSERT_TRUE(write_file(folder.name("link.nc"), "new"));
  EXPECT_TRUE(fs::is_symlink(folder.name("link.nc")));
  EXPECT_EQ(read_text(target), "new");
}

TEST(WriteFile, AFullDeviceIsAnError) {
  const auto written = write_file("/dev/full", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().error, ENOSPC);
}

TEST(WriteFile, AMissingFolderOrAFolderIsAnError) {
  const TemporaryFolder folder;
  EXPECT_EQ(write_file(folder.name("no/a.nc"), "x").error().error, ENOENT);
  EXPECT_EQ(write_file(folder.path(), "x").error().error, EISDIR);
  EXPECT_THAT(folder.entries(), IsEmpty());
}

TEST(WriteFile, ANameThatFitsNoFileLeavesNothingBehind) {
  const TemporaryFolder folder;
  EXPECT_EQ(write_file(folder.name(std::string(300, 'a')), "x").error().error, ENAMETOOLONG);
  EXPECT_THAT(folder.entries(), IsEmpty());
}

TEST(WriteFile, AReadOnlyFileOrFolderIsRefused) {
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is read-only for the superuser";
  const TemporaryFolder folder;
  const std::string file = folder.write("a.nc", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  EXPECT_EQ(write_file(file, "new").error().error, EACCES);
  EXPECT_EQ(read_text(file), "old");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  EXPECT_EQ(write_file(folder.name("b.nc"), "x").error().error, EACCES);
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  EXPECT_THAT(folder.entries(), ElementsAre("a.nc"));
}

}  // namespace
}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/internal_error.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/support/command.h"

namespace dgt {
namespace {

using support::read_text;
using support::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string own_name(const char* suffix = "") {
  return "dgt-internal-error-" + std::to_string(::getpid()) + suffix + ".txt";
}

TEST(InternalError, IsSavedWithTheCommandLineAndTheFilesItNames) {
  const TemporaryFolder folder;
  const TemporaryFolder inputs;
  const std::string program = inputs.write("part 1.bgt", "L1=Y2\nK1 L1");
  const auto saved = save_internal_error(
      {"check failed", {"check", program, "--set", "torch_on=M3 S1", "it's"}}, folder.path());
  ASSERT_TRUE(saved.has_value());
  EXPECT_EQ(*saved, folder.name(own_name()));
  const std::string text = read_text(*saved);
  EXPECT_THAT(text, StartsWith("dgt "));
  EXPECT_THAT(text, HasSubstr("\ninternal error: check failed\n\ndgt check '" + program +
                              "' --set 'torch_on=M3 S1' 'it'\\''s'\n"));
  EXPECT_THAT(text, EndsWith("\n--- " + program + ", 11 bytes\nL1=Y2\nK1 L1"));
}

TEST(InternalError, NothingThatExistsIsWrittenOver) {
  const TemporaryFolder folder;
  folder.write(own_name(), "old");
  EXPECT_EQ(*save_internal_error({"x", {}}, folder.path()), folder.name(own_name("-1")));
  EXPECT_EQ(read_text(folder.name(own_name())), "old");
}

TEST(InternalError, IsForTheUsersEyesOnly) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const auto saved = save_internal_error({"x", {}}, folder.path());
  EXPECT_EQ(fs::status(*saved).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(InternalError, AFolderThatIsNotThereIsAFailure) {
  const TemporaryFolder folder;
  EXPECT_FALSE(save_internal_error({"x", {}}, folder.name("no")).has_value());
  EXPECT_THAT(folder.entries(), ElementsAre());
}

TEST(InternalError, FoldersAndLargeFilesAreNamedOnly) {
  const TemporaryFolder folder;
  const std::string large = folder.write("large.bgt", "");
  std::filesystem::resize_file(large, kMostSavedBytes + 1);
  const auto saved = save_internal_error({"x", {folder.path(), large}}, folder.path());
  EXPECT_THAT(read_text(*saved), HasSubstr(large + "\n"));
  EXPECT_THAT(read_text(*saved), Not(HasSubstr("---")));
}

}  // namespace
}  // namespace dgt

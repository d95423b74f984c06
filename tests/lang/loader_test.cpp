// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/loader.h"

#include <gtest/gtest.h>

#include <fstream>

namespace dgt {
namespace {

namespace fs = std::filesystem;

// A folder of the program `p`, its `mac`, and a folder of the settings `s`.
class FolderLoaderTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    for (const char* folder : {"p/mac", "s"}) fs::create_directories(root_ / folder);
  }
  void TearDown() override { fs::remove_all(root_); }

  void put(const std::string& name) { std::ofstream(root_ / name) << name; }
  std::string macro(std::string_view name) {
    const auto found = FolderLoader(root_ / "p", {root_ / "s"}).load_macro(name);
    return found ? found->bytes : "none";
  }

  const fs::path root_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(FolderLoaderTest, LooksBesideTheProgramThenInItsMacThenInTheSettingsFolders) {
  put("s/A.mac");
  EXPECT_EQ(macro("A"), "s/A.mac");
  put("p/mac/A.mac");
  EXPECT_EQ(macro("A"), "p/mac/A.mac");
  put("p/A.mac");
  EXPECT_EQ(macro("A"), "p/A.mac");
}

TEST_F(FolderLoaderTest, MacGoesBeforeBgt) {
  put("p/A.bgt");
  EXPECT_EQ(macro("A"), "p/A.bgt");
  put("p/A.mac");
  EXPECT_EQ(macro("A"), "p/A.mac");
}

TEST_F(FolderLoaderTest, CaseIsInsignificantAlsoInCyrillic) {
  put("p/KVAD.MAC");
  EXPECT_EQ(macro("kvad"), "p/KVAD.MAC");
  put("p/Плита.mac");
  EXPECT_EQ(macro("ПЛИТА"), "p/Плита.mac");
}

TEST_F(FolderLoaderTest, ANameWrittenExactlySoGoesFirst) {
  put("p/kvad.mac");
  put("p/KVAD.mac");
  EXPECT_EQ(macro("kvad"), "p/kvad.mac");
  EXPECT_EQ(macro("KVAD"), "p/KVAD.mac");
  EXPECT_EQ(macro("Kvad"), "p/KVAD.mac") << "the first by name, on every disk";
}

TEST_F(FolderLoaderTest, NoNameLeadsOutOfTheFolders) {
  put("s/A.mac");
  EXPECT_EQ(macro("../s/A"), "none");
}

TEST_F(FolderLoaderTest, DefinitionsStandBesideTheProgramOnly) {
  put("p/det.bgt");
  put("s/other.bgt");
  FolderLoader loader(root_ / "p", {root_ / "s"});
  EXPECT_TRUE(loader.load_definitions("DET").has_value());
  EXPECT_FALSE(loader.load_definitions("other").has_value());
}

TEST_F(FolderLoaderTest, AnUnsavedProgramHasTheSettingsFolders) {
  put("s/A.mac");
  FolderLoader loader(std::nullopt, {root_ / "s"});
  EXPECT_FALSE(loader.has_folder());
  EXPECT_TRUE(loader.load_macro("a").has_value());
  EXPECT_FALSE(loader.load_definitions("A").has_value());
}

}  // namespace
}  // namespace dgt

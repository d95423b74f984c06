// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every program of tests/corpus against what it gave when a person last looked at it. A change of
// any figure shows as a changed golden file: `DGT_UPDATE_GOLDEN=1 ctest -R Corpus` rewrites them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::Outcome;
using support::read_text;

/// One golden file of each kind belongs to every program; with `.txt` added when refused.
struct Output {
  const char* extension;
  std::vector<std::string> arguments;  ///< before the name of the program
};

const std::vector<Output> kOutputs = {
    {".path", {"dump"}},
    {".ess", {"compile", "--post", "essi"}},
    {".cnc", {"compile", "--post", "plasmatic"}},
    {".ngc", {"compile", "--post", "linuxcnc"}},
};

/// Of these programs there are more.
const std::vector<std::string> kRichPrograms = {"1P", "kvad-square", "rows/contour_crc",
                                                "rows/contour_w"};
const std::vector<Output> kMoreOutputs = {
    {".iso", {"compile", "--post", "essi-iso"}},
    {".fanuc", {"compile", "--post", "fanuc-wire"}},
    {".grbl", {"compile", "--post", "grbl"}},
    {".3b", {"compile", "--post", "3b"}},
    {".control", {"compile", "--post", "linuxcnc", "--compensation", "control"}},
};
/// And of those that are in it themselves.
const Output kThreeB = {".3b", {"convert", "--to", "3b"}};
/// What they are in the language, where a person looks at it.
const Output kSource = {".dgt", {"convert", "--to", "dgt"}};

std::vector<Output> outputs_of(const std::string& program) {
  std::vector<Output> outputs = kOutputs;
  if (std::ranges::find(kRichPrograms, program) != kRichPrograms.end())
    outputs.insert(outputs.end(), kMoreOutputs.begin(), kMoreOutputs.end());
  if (program.starts_with("three_b/")) outputs.push_back(kThreeB);
  const bool is_short = program != "dxf/blocks.dxf" && program != "dxf/spline.dxf";
  if (is_short) outputs.push_back(kSource);
  return outputs;
}

fs::path folder() { return support::corpus(""); }
fs::path golden(const std::string& file) { return folder() / "golden" / file; }

/// The programs, as paths from the corpus' folder, `.bgt` left out, in order.
std::vector<std::string> programs() {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder())) {
    fs::path name = entry.path().lexically_relative(folder());
    if (*name.begin() == "golden") continue;
    if (name.extension() == ".bgt") names.push_back(name.replace_extension().string());
    static const std::set<fs::path> kOthers = {".ess", ".cnc", ".3b", ".dxf"};
    if (kOthers.contains(name.extension())) names.push_back(name.string());
  }
  std::ranges::sort(names);
  return names;
}

/// Run from the corpus' folder, so that messages name files the same way everywhere.
Outcome run(std::vector<std::string> arguments, const std::string& program) {
  arguments.push_back(fs::path(program).has_extension() ? program : program + ".bgt");
  return support::run_dgt(arguments, {.folder = folder()});
}

bool updating() { return std::getenv("DGT_UPDATE_GOLDEN") != nullptr; }

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

void hold_against_golden(const std::string& name, const Outcome& outcome) {
  const bool done = outcome.exit_code == 0;
  const fs::path given = golden(name);
  const fs::path refused = golden(name + ".txt");
  const std::string& text = done ? outcome.out : outcome.err;
  if (updating()) {
    fs::remove(done ? refused : given);
    write(done ? given : refused, text);
    return;
  }
  ASSERT_TRUE(fs::exists(done ? given : refused))
      << name << (done ? ": used to be refused\n" : ": used to be written\n") << text;
  EXPECT_EQ(text, read_text(done ? given : refused)) << name;
}

// --- every program ------------------------------------------------------------------------------

class CorpusProgram : public ::testing::TestWithParam<std::string> {};

TEST_P(CorpusProgram, GivesItsGoldenFiles) {
  for (const Output& output : outputs_of(GetParam())) {
    const Outcome outcome = run(output.arguments, GetParam());
    ASSERT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.err;
    hold_against_golden(GetParam() + output.extension, outcome);
  }
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Corpus, CorpusProgram, ::testing::ValuesIn(programs()), test_name);

TEST(Corpus, EveryGoldenFileBelongsToAProgram) {
  const std::vector<std::string> all = programs();
  std::set<fs::path> wanted;
  for (const std::string& program : all) {
    for (const Output& output : outputs_of(program)) {
      wanted.insert(golden(program + output.extension));
      wanted.insert(golden(program + output.extension + ".txt"));
    }
  }
  ASSERT_GT(all.size(), 100U);
  for (const auto& entry : fs::recursive_directory_iterator(golden(""))) {
    if (!entry.is_regular_file()) continue;
    EXPECT_TRUE(wanted.contains(entry.path())) << entry.path();
  }
}

// --- written, read and written again ------------------------------------------------------------

TEST(Corpus, WhatIsWrittenComesBackByteForByteWhenReadAndWrittenAgain) {
  struct Dialect {
    std::string name;
    std::string language;
  };
  const std::map<fs::path, Dialect> dialects = {{".ess", {"essi", "essi"}},
                                                {".iso", {"essi-iso", "essi-iso"}},
                                                {".cnc", {"plasmatic", "gcode"}},
                                                {".ngc", {"linuxcnc", "gcode"}},
                                                {".fanuc", {"fanuc-wire", "gcode"}},
                                                {".grbl", {"grbl", "gcode"}},
                                                {".3b", {"3b", "3b"}}};
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(golden(""))) {
    const auto dialect = dialects.find(entry.path().extension());
    if (dialect == dialects.end()) continue;
    const Outcome again =
        support::run_dgt({"convert", entry.path().string(), "--to", dialect->second.name, "--from",
                          dialect->second.language});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(again.out, read_text(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 300U);
}

// --- programs that say the same -----------------------------------------------------------------

/// The path without the places in the source.
json path_of(const std::string& program) {
  const Outcome outcome = run({"path"}, program);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  json path = json::parse(outcome.out);
  const auto forget_places = [](json& moves) {
    for (json& move : moves) move.erase("source");
  };
  forget_places(path["moves"]);
  for (json& contour : path["contours"]) {
    forget_places(contour["programmed"]);
    forget_places(contour["moves"]);
  }
  return path;
}

void expect_same_path(const std::string& program, const std::string& other) {
  const json path = path_of(program);
  EXPECT_FALSE(path["moves"].empty());
  EXPECT_EQ(path, path_of(other)) << program << " and " << other;
}

TEST(Corpus, ALoopGivesThePathOfItsTurnsWrittenOut) { expect_same_path("1P", "2P"); }
TEST(Corpus, VariablesGiveThePathOfTheirValues) { expect_same_path("4P", "4P-plain"); }
TEST(Corpus, ALoopInAContourGivesThePathOfItsTurnsWrittenOut) {
  expect_same_path("rows/contour_lal", "rows/loop_contour");
}

}  // namespace
}  // namespace dgt

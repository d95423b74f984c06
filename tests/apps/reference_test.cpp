// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference of the language, lang/README.md, against the compiler: its programs, its drawings,
// its table of messages. `DGT_UPDATE_GOLDEN=1 ctest -R Reference` makes what is made anew.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "lang/text/diagnostic.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using support::Outcome;
using support::read_text;

fs::path lang() { return fs::path(DGT_SOURCE_DIR) / "lang"; }
fs::path rows() { return support::corpus("rows"); }
fs::path corners() { return support::corpus("corners"); }
bool updating() { return std::getenv("DGT_UPDATE_GOLDEN") != nullptr; }
void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::vector<std::string> names_in(const fs::path& folder, const std::string& extension) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}

// --- what the page is filled with ---------------------------------------------------------------

std::string row_on_page(const std::string& name) {
  return fmt::format(
      "<table><tr><td><img src=\"figures/{0}.svg\" alt=\"{0}\"></td><td>\n\n```dgt\n{1}```\n\n"
      "[`{0}`](../tests/corpus/rows/{0}.bgt)\n\n</td></tr></table>\n",
      name, read_text(rows() / (name + ".bgt")));
}

std::string in_cell(const std::string& text) {
  return std::regex_replace(text, std::regex("\\|"), "\\|");
}

std::string messages_on_page() {
  std::vector<MessageInfo> all(all_messages().begin(), all_messages().end());
  std::ranges::sort(all, {}, [](const MessageInfo& row) { return std::string(row.code); });
  std::string out = "| code | | message |\n| --- | --- | --- |\n";
  for (const MessageInfo& row : all) {
    const char* const severity = row.severity == Severity::Error     ? "error"
                                 : row.severity == Severity::Warning ? "warning"
                                                                     : "note";
    out += fmt::format("| {} | {} | {} |\n", row.code, severity, in_cell(std::string(row.english)));
  }
  return out;
}

/// The page with everything between a mark and `<!-- end -->` as it should be.
std::string filled(const std::string& page) {
  static const std::regex kMark("<!-- (row [a-z0-9_]+|messages) -->");
  std::istringstream lines(page);
  std::string out;
  bool skipping = false;
  for (std::string line; std::getline(lines, line);) {
    skipping = skipping && line != "<!-- end -->";
    if (skipping) continue;
    out += line + "\n";
    std::smatch mark;
    if (!std::regex_match(line, mark, kMark)) continue;
    const std::string what = mark[1];
    out += what == "messages" ? messages_on_page() : row_on_page(what.substr(4));
    skipping = true;
  }
  return out;
}

TEST(Reference, RowsAndMessagesOnThePageAreThoseOfTheProject) {
  const fs::path page = lang() / "README.md";
  if (updating()) write(page, filled(read_text(page)));
  EXPECT_EQ(read_text(page), filled(read_text(page)))
      << "DGT_UPDATE_GOLDEN=1 ctest -R Reference fills the page anew";
}

TEST(Reference, ShowsEveryRowOfTheTablesOnce) {
  const std::string page = read_text(lang() / "README.md");
  const std::vector<std::string> names = names_in(rows(), ".bgt");
  ASSERT_GT(names.size(), 100U);
  for (const std::string& name : names) {
    const std::string mark = "<!-- row " + name + " -->";
    const auto at = page.find(mark);
    EXPECT_NE(at, std::string::npos) << name << " is not in lang/README.md";
    EXPECT_EQ(page.find(mark, at + 1), std::string::npos) << name << " is there twice";
  }
}

// --- figures ------------------------------------------------------------------------------------

class ReferenceFigure : public ::testing::TestWithParam<std::string> {};

TEST_P(ReferenceFigure, IsWhatPlotDraws) {
  const fs::path figure = lang() / "figures" / (GetParam() + ".svg");
  const Outcome plot = support::run_dgt({"plot", "--names", "--size", "480", GetParam() + ".bgt"},
                                        {.folder = rows()});
  ASSERT_EQ(plot.exit_code, 0) << plot.err;
  if (updating()) write(figure, plot.out);
  ASSERT_TRUE(fs::exists(figure)) << figure;
  EXPECT_EQ(plot.out, read_text(figure));
}

INSTANTIATE_TEST_SUITE_P(Reference, ReferenceFigure, ::testing::ValuesIn(names_in(rows(), ".bgt")),
                         [](const auto& row) { return row.param; });

TEST(Reference, EveryFigureBelongsToARow) {
  EXPECT_EQ(names_in(lang() / "figures", ".svg"), names_in(rows(), ".bgt"));
}

class CornerFigure : public ::testing::TestWithParam<std::string> {};

TEST_P(CornerFigure, IsWhatPlotDraws) {
  const fs::path figure = lang() / "figures" / "corners" / (GetParam() + ".svg");
  const Outcome plot =
      support::run_dgt({"plot", "--size", "320", "--machine", GetParam() + ".toml", "tooth.bgt"},
                       {.folder = corners()});
  ASSERT_EQ(plot.exit_code, 0) << plot.err;
  if (updating()) write(figure, plot.out);
  ASSERT_TRUE(fs::exists(figure)) << figure;
  EXPECT_EQ(plot.out, read_text(figure));
}

INSTANTIATE_TEST_SUITE_P(Reference, CornerFigure, ::testing::ValuesIn(names_in(corners(), ".toml")),
                         [](const auto& style) { return style.param; });

// --- programs of the page -----------------------------------------------------------------------

struct Block {
  std::string code;  ///< with which it fails; empty: it compiles
  std::string text;
  std::size_t line = 0;
};

std::vector<Block> blocks_of(const std::string& page) {
  static const std::regex kFence("```dgt(-error (DGT[0-9]{4}))?");
  std::vector<Block> blocks;
  std::istringstream lines(page);
  std::size_t number = 0;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch fence;
    if (inside && line == "```") {
      inside = false;
    } else if (inside) {
      blocks.back().text += line + "\n";
    } else if (std::regex_match(line, fence, kFence)) {
      blocks.push_back({fence[2], "", number});
      inside = true;
    } else {
      EXPECT_FALSE(line.starts_with("```dgt")) << "line " << number << ": " << line;
    }
  }
  EXPECT_FALSE(inside);
  return blocks;
}

TEST(Reference, EveryProgramCompilesOrFailsAsThePageSays) {
  const support::TemporaryFolder folder;
  fs::copy(rows() / "mac", folder.path() / "mac");
  fs::copy(rows() / "det1opr.bgt", folder.path() / "det1opr.bgt");
  const std::vector<Block> blocks = blocks_of(read_text(lang() / "README.md"));
  ASSERT_GT(blocks.size(), 110U);
  for (const Block& block : blocks) {
    const Outcome check = support::run_dgt({"check", folder.write("program.bgt", block.text)});
    const std::string where = fmt::format("lang/README.md:{}\n{}", block.line, check.err);
    if (block.code.empty()) {
      EXPECT_EQ(check.exit_code, 0) << where;
      continue;
    }
    EXPECT_EQ(check.exit_code, 1) << where;
    std::set<std::string> errors;
    static const std::regex kError(": error: [^\n]*\\[(DGT[0-9]{4})\\]");
    for (std::sregex_iterator at(check.err.begin(), check.err.end(), kError), end; at != end; ++at)
      errors.insert((*at)[1]);
    EXPECT_EQ(errors, std::set<std::string>{block.code}) << where;
  }
}

}  // namespace
}  // namespace dgt

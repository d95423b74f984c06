// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs as they come from a hand on a bad day. Each slips/NAME.bgt is compiled, and everything a
// person sees of it stands in NAME.en.txt and NAME.ru.txt, to be read line by line whenever it
// changes: DGT_UPDATE_GOLDEN=1 writes them anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "lang/dgt/compile.h"
#include "lang/text/render.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;

const fs::path& folder() {
  static const fs::path kFolder = fs::path(DGT_SOURCE_DIR) / "tests" / "lang" / "slips";
  return kFolder;
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Macros and definition files from the folder `beside`, under their names alone: messages are not
// to say where the tests lie.
class BesideLoader : public SourceLoader {
 public:
  explicit BesideLoader(bool saved) : saved_(saved) {}

  std::optional<SourceText> load_macro(std::string_view name) override {
    return nameless(files_.load_macro(name));
  }
  std::optional<SourceText> load_definitions(std::string_view name) override {
    return nameless(files_.load_definitions(name));
  }
  bool has_folder() const override { return saved_; }

 private:
  static std::optional<SourceText> nameless(std::optional<SourceText> text) {
    if (text) text->name = fs::path(text->name).filename().string();
    return text;
  }
  FolderLoader files_{folder() / "beside", {}};
  bool saved_;
};

// What a program is compiled with that its name speaks of.
EvaluateOptions options_for(const std::string& name) {
  EvaluateOptions options;
  if (name == "bounds_statements") options.bounds.statements = 5000;
  if (name == "bounds_moves") options.bounds.moves = 5000;
  if (name == "bounds_texts") options.bounds.text_depth = 2;
  if (name == "bounds_macros") options.bounds.macro_depth = 2;
  return options;
}

class Slips : public testing::TestWithParam<std::string> {};

TEST_P(Slips, AreToldAsTheGoldenFileSays) {
  const std::string& name = GetParam();
  const SourceFile file(name + ".bgt", content_of(folder() / (name + ".bgt")));
  BesideLoader loader(name.find("unsaved") == std::string::npos);
  const EvaluateOptions options = options_for(name);
  DiagnosticBag bag;
  const CompileResult result = compile(file, loader, options, bag);
  EXPECT_EQ(result.path.has_value(), !bag.has_errors());
  for (const Language language : {Language::English, Language::Russian}) {
    const std::string shown = render(bag, {language, Colour::Plain});
    const fs::path golden =
        folder() / (name + (language == Language::English ? ".en.txt" : ".ru.txt"));
    if (std::getenv("DGT_UPDATE_GOLDEN") != nullptr) {
      std::ofstream(golden, std::ios::binary) << shown;
    }
    ASSERT_TRUE(fs::exists(golden)) << golden << ": DGT_UPDATE_GOLDEN=1 writes it";
    EXPECT_EQ(shown, content_of(golden)) << "if this is better, DGT_UPDATE_GOLDEN=1 keeps it";
  }
}

std::vector<std::string> all_slips() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder())) {
    if (entry.path().extension() == ".bgt") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Programs, Slips, testing::ValuesIn(all_slips()),
                         [](const auto& slip) { return slip.param; });

}  // namespace
}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs as they come from a hand on a bad day. Each slips/NAME.bgt is compiled, each .ess, .nc,
// .cnc and .3b read, and everything a person sees of it stands in NAME.en.txt and NAME.ru.txt, to
// be read line by line whenever it changes: DGT_UPDATE_GOLDEN=1 writes them anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "lang/dgt/compile.h"
#include "lang/essi/reader.h"
#include "lang/gcode/reader.h"
#include "lang/nc/kerf.h"
#include "lang/text/render.h"
#include "lang/three_b/reader.h"

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

bool is_iso(const std::string& name) { return name.find("_iso_") != std::string::npos; }

void finish(const SourceFile& file, NcProgram program, DiagnosticBag& bag) {
  if (!bag.has_errors()) (void)with_kerf(file, std::move(program), ContourOptions{}, bag);
}

/// Reads or compiles the program `file`, called `name` without its extension. The result holds
/// what diagnostics point into.
CompileResult examine(const SourceFile& file, const std::string& name, DiagnosticBag& bag) {
  const fs::path extension = fs::path(file.name()).extension();
  if (extension == ".ess") {
    EssiOptions options;
    if (is_iso(name)) options.dialect = EssiDialect::Iso;
    options.nc.repair = name.find("repair") != std::string::npos;
    finish(file, read_essi(file, options, bag), bag);
  } else if (extension == ".nc" || extension == ".cnc") {
    finish(file, read_gcode(file, GcodeOptions{}, bag), bag);
  } else if (extension == ".3b") {
    finish(file, read_three_b(file, ThreeBOptions{}, bag), bag);
  } else {
    BesideLoader loader(name.find("unsaved") == std::string::npos);
    CompileResult result = compile(file, loader, options_for(name), bag);
    EXPECT_EQ(result.path.has_value(), !bag.has_errors());
    return result;
  }
  bag.sort();
  return {};
}

class Slips : public testing::TestWithParam<std::string> {};

TEST_P(Slips, AreToldAsTheGoldenFileSays) {
  const std::string name = fs::path(GetParam()).stem().string();
  const SourceFile file(GetParam(), content_of(folder() / GetParam()));
  DiagnosticBag bag;
  const CompileResult result = examine(file, name, bag);
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
    if (entry.is_regular_file() && entry.path().extension() != ".txt")
      names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Programs, Slips, testing::ValuesIn(all_slips()),
                         [](const auto& slip) { return fs::path(slip.param).stem().string(); });

}  // namespace
}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/invocation.h"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace dgt::studio {
namespace {

constexpr QSize kPictureSize(1366, 768);
constexpr QSize kSmallest(320, 240);
constexpr QSize kLargest(7680, 4320);

const std::map<std::string, View> kViews = {{"draw", View::Draw},
                                            {"nc", View::Nc},
                                            {"points", View::Points},
                                            {"wizard", View::Wizard},
                                            {"tape", View::Tape}};
const std::map<std::string, Language> kLanguages = {{"en", Language::English},
                                                    {"ru", Language::Russian}};
const std::map<std::string, Theme> kThemes = {{"light", Theme::Light}, {"dark", Theme::Dark}};

/// `1366x768`.
std::optional<QSize> size_of(const std::string& text) {
  const QStringList parts = QString::fromStdString(text).split(u'x');
  bool wide = false;
  bool high = false;
  const QSize size(parts.value(0).toInt(&wide), parts.value(1).toInt(&high));
  if (parts.size() != 2 || !wide || !high) return std::nullopt;
  const bool fits = size.expandedTo(kSmallest) == size && size.boundedTo(kLargest) == size;
  return fits ? std::optional(size) : std::nullopt;
}

/// As the words of the command line say them.
struct Words {
  std::string file, language, theme, machine, picture, view = "draw", size = "1366x768";
};

template <typename Value>
std::vector<std::string> names_of(const std::map<std::string, Value>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  return names;
}

Invocation invocation_of(const Words& words) {
  Invocation made;
  made.file = QString::fromStdString(words.file);
  made.machine_file = QString::fromStdString(words.machine);
  if (!words.language.empty()) made.language = kLanguages.at(words.language);
  if (!words.theme.empty()) made.theme = kThemes.at(words.theme);
  if (!words.picture.empty()) {
    made.picture = Picture{QString::fromStdString(words.picture), kViews.at(words.view),
                           size_of(words.size).value_or(kPictureSize)};
  }
  return made;
}

void declare(CLI::App& app, Words& words) {
  app.set_version_flag("--version", "dgt-studio " DGT_VERSION, "The version of the program");
  app.add_option("FILE", words.file, "A program to open")->option_text(" ");
  app.add_option("--lang", words.language, "en or ru; without it as chosen last")
      ->check(CLI::IsMember(names_of(kLanguages)))
      ->option_text("LANG");
  app.add_option("--theme", words.theme, "light or dark; without it as chosen last")
      ->check(CLI::IsMember(names_of(kThemes)))
      ->option_text("THEME");
  app.add_option("--machine", words.machine, "Settings of the machine, a TOML file")
      ->option_text("FILE");
  CLI::Option* const picture =
      app.add_option("--screenshot", words.picture,
                     "Save a PNG of the window with FILE once it has been executed, and end; needs "
                     "no screen, and settings of the person who runs it do not matter")
          ->option_text("OUT.png");
  app.add_option("--view", words.view, "What it shows: draw, nc, points, wizard or tape")
      ->check(CLI::IsMember(names_of(kViews)))
      ->needs(picture)
      ->option_text("VIEW");
  app.add_option("--size", words.size, "Its size in pixels, 1366x768 by default")
      ->check([](const std::string& text) {
        return size_of(text) ? std::string()
                             : "expected WIDTHxHEIGHT from 320x240 to 7680x4320, not " + text;
      })
      ->needs(picture)
      ->option_text("WxH");
  app.footer(
      "Exit codes:\n"
      "  0  done, whatever the messages about FILE say\n"
      "  2  wrong usage\n"
      "  3  a file failed, or there is no screen\n");
}

}  // namespace

Parsed parse(int argc, const char* const* argv) {
  Words words;
  CLI::App app("DGT Studio: contours for wire and plasma cutting", "dgt-studio");
  declare(app, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& end) {
    return {std::nullopt, app.exit(end) == 0 ? 0 : kWrongUsage};
  }
  return {invocation_of(words), 0};
}

}  // namespace dgt::studio

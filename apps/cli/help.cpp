// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/help.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace dgt::cli {
namespace {

constexpr std::size_t kColumns = 80;
constexpr std::size_t kIndent = 2;    // of the names of options and verbs
constexpr std::size_t kText = 6;      // of what is said about them
constexpr std::size_t kSummary = 12;  // where verbs are told in one line each

/// Columns a text takes: its characters, and none for the further bytes of one.
std::size_t width(std::string_view text) {
  std::size_t columns = 0;
  for (const char c : text) columns += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
  return columns;
}

void append_line(std::string& out, const std::string& line, std::size_t indent) {
  if (width(line) + indent <= kColumns) {  // what fits keeps its blanks: tables
    out.append(line.empty() ? 0 : indent, ' ').append(line) += '\n';
    return;
  }
  std::size_t column = 0;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + width(word) > kColumns) {
      out += '\n';
      column = 0;
    }
    out.append(column == 0 ? indent : 1, ' ').append(word);
    column += (column == 0 ? indent : 1) + width(word);
  }
  out += '\n';
}

/// Fills lines; line ends and leading blanks of the text stay.
std::string filled(const std::string& text, std::size_t indent) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    append_line(out, line.substr(blanks), indent + blanks);
  }
  return out;
}

std::string without_trailing_blanks(std::string text) {
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

class ManualFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
    for (auto at = help.find("\n\n\n"); at != std::string::npos; at = help.find("\n\n\n")) {
      help.erase(at, 1);
    }
    return help;
  }
  std::string make_description(const CLI::App* app) const override {
    return filled(app->get_description(), 0) + "\n";
  }
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    return without_trailing_blanks(std::string(kIndent, ' ') +
                                   make_option_name(option, is_positional) +
                                   make_option_opts(option)) +
           "\n" + filled(make_option_desc(option), kText);
  }
  /// The first line of a verb's description is what it does in short.
  std::string make_subcommand(const CLI::App* verb) const override {
    std::string name = std::string(kIndent, ' ') + verb->get_name();
    name.resize(std::max(kSummary, name.size() + 1), ' ');
    const std::string description = verb->get_description();
    return name + description.substr(0, description.find('\n')) + "\n";
  }
  std::string make_footer(const CLI::App* app) const override {
    const std::string footer = app->get_footer();
    return footer.empty() ? "" : "\n" + filled(footer, 0);
  }
};

}  // namespace

std::shared_ptr<CLI::Formatter> manual_formatter() { return std::make_shared<ManualFormatter>(); }

}  // namespace dgt::cli

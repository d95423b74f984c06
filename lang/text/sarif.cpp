// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/sarif.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace dgt {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSchema = "https://json.schemastore.org/sarif-2.1.0.json";

// The names of the IANA registry, which the standard asks for.
std::string_view iana_name(Encoding encoding) {
  switch (encoding) {
    case Encoding::Windows1251:
      return "windows-1251";
    case Encoding::Cp866:
      return "IBM866";
    case Encoding::Koi8R:
      return "KOI8-R";
    case Encoding::Utf8:
      break;
  }
  return "UTF-8";
}

std::string_view level(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "error";
    case Severity::Warning:
      return "warning";
    case Severity::Note:
      break;
  }
  return "note";
}

bool is_plain_in_uri(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

// RFC 3986; the bytes of a name that is no UTF-8 stand as they are.
std::string uri_of(std::string_view name) {
  std::string uri = name.starts_with('/') ? "file://" : "";
  for (const char c : name) {
    if (is_plain_in_uri(c)) {
      uri += c;
    } else {
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return uri;
}

Json text_object(std::string_view text) { return {{"text", text}}; }

// In a message string `{0}` is a placeholder and a brace is written twice (section 3.11.5).
std::string with_braces_doubled(std::string_view text) {
  std::string doubled;
  for (const char c : text) doubled.append(c == '{' || c == '}' ? 2 : 1, c);
  return doubled;
}

// The column of an offset in its line, from 1; a line end counts as one place behind the text.
std::uint32_t column_of(const SourceFile& file, std::uint32_t line, std::uint32_t offset) {
  const std::string_view text = file.line_text(line);
  const std::size_t length = std::min<std::size_t>(offset - file.line_start(line), text.size());
  return count_code_points(text.substr(0, length)) + 1;
}

Json region(const Range& range) {
  const std::uint32_t first = range.file->line_at(range.begin);
  const std::uint32_t last = range.file->line_at(range.end);
  return {{"startLine", first},
          {"startColumn", column_of(*range.file, first, range.begin)},
          {"endLine", last},
          {"endColumn", column_of(*range.file, last, range.end)}};
}

// Gathers rules and files as results mention them.
class Run {
 public:
  explicit Run(const SarifOptions& options) : options_(options) {}

  void add(const Diagnostic& d) {
    Json result = {{"ruleId", d.code()},
                   {"ruleIndex", rule_index(d.message)},
                   {"level", level(d.severity())},
                   {"message", message(d.message, d.arguments)},
                   {"locations", Json::array({location(d.range)})}};
    if (d.other) result["relatedLocations"].push_back(location(*d.other));
    for (const Note& note : d.notes) {
      Json related = location(note.range);
      related["message"] = text_object(sentence(note.message, note.arguments));
      result["relatedLocations"].push_back(std::move(related));
    }
    if (d.fix_it) result["fixes"] = Json::array({fix(*d.fix_it)});
    results_.push_back(std::move(result));
  }

  [[nodiscard]] Json log() const {
    Json driver = {{"name", "dgt"}};
    if (!options_.version.empty()) driver["version"] = options_.version;
    driver["rules"] = Json::array();
    for (const Message rule : rules_) driver["rules"].push_back(rule_object(rule));
    Json files = Json::array();
    for (const SourceFile* file : files_) {
      files.push_back({{"location", {{"uri", uri_of(file->name())}}},
                       {"encoding", iana_name(file->form().encoding)}});
    }
    Json run = {{"tool", {{"driver", std::move(driver)}}},
                {"language", options_.language == Language::Russian ? "ru" : "en"},
                {"columnKind", "unicodeCodePoints"},
                {"artifacts", std::move(files)},
                {"results", results_}};
    if (!options_.failures.empty()) run["invocations"] = Json::array({invocation()});
    return {{"$schema", kSchema}, {"version", "2.1.0"}, {"runs", Json::array({std::move(run)})}};
  }

 private:
  std::size_t rule_index(Message message) {
    const auto found = std::ranges::find(rules_, message);
    if (found == rules_.end()) {
      rules_.push_back(message);
      return rules_.size() - 1;
    }
    return static_cast<std::size_t>(found - rules_.begin());
  }

  // One name is one artifact, though two programs may have loaded it.
  std::size_t file_index(const SourceFile* file) {
    const auto found = std::ranges::find(files_, file->name(), &SourceFile::name);
    if (found == files_.end()) {
      files_.push_back(file);
      return files_.size() - 1;
    }
    return static_cast<std::size_t>(found - files_.begin());
  }

  static Json rule_object(Message rule) {
    const MessageInfo& row = info(rule);
    return {
        {"id", row.code},
        {"name", row.name},
        {"fullDescription", text_object(row.english)},
        {"help", text_object(row.russian)},
        {"messageStrings", {{"en", text_object(row.english)}, {"ru", text_object(row.russian)}}},
        {"defaultConfiguration", {{"level", level(row.severity)}}}};
  }

  [[nodiscard]] Json invocation() const {
    Json notifications = Json::array();
    for (const std::string& failure : options_.failures) {
      notifications.push_back({{"level", "error"}, {"message", text_object(visible(failure))}});
    }
    return {{"executionSuccessful", false},
            {"toolExecutionNotifications", std::move(notifications)}};
  }

  [[nodiscard]] std::string sentence(Message which,
                                     const std::vector<std::string>& arguments) const {
    return with_braces_doubled(text(which, arguments, options_.language));
  }

  [[nodiscard]] Json message(Message which, const std::vector<std::string>& arguments) const {
    Json object = text_object(sentence(which, arguments));
    object["id"] = options_.language == Language::Russian ? "ru" : "en";
    if (!arguments.empty()) {
      object["arguments"] = Json::array();
      for (const std::string& argument : arguments)
        object["arguments"].push_back(visible(argument));
    }
    return object;
  }

  Json artifact(const SourceFile* file) {
    return {{"uri", uri_of(file->name())}, {"index", file_index(file)}};
  }

  Json location(const Range& range) {
    Json physical = {{"artifactLocation", artifact(range.file)}, {"region", region(range)}};
    return {{"physicalLocation", std::move(physical)}};
  }

  Json fix(const FixIt& fix_it) {
    Json replacement = {{"deletedRegion", region(fix_it.range)},
                        {"insertedContent", text_object(fix_it.replacement)}};
    Json change = {{"artifactLocation", artifact(fix_it.range.file)},
                   {"replacements", Json::array({std::move(replacement)})}};
    return {{"artifactChanges", Json::array({std::move(change)})}};
  }

  const SarifOptions& options_;
  std::vector<Message> rules_;
  std::vector<const SourceFile*> files_;
  Json results_ = Json::array();
};

}  // namespace

std::string to_sarif(std::span<const DiagnosticBag* const> bags, const SarifOptions& options) {
  Run run(options);
  for (const DiagnosticBag* bag : bags) {
    for (const Diagnostic& diagnostic : bag->all()) run.add(diagnostic);
  }
  return run.log().dump(2) + "\n";
}

std::string to_sarif(const DiagnosticBag& bag, const SarifOptions& options) {
  const DiagnosticBag* const one[] = {&bag};
  return to_sarif(one, options);
}

}  // namespace dgt

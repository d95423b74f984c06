// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/sarif.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>

namespace dgt {
namespace {

using Json = nlohmann::json;

// The checks below follow the sections of SARIF 2.1.0 (OASIS standard) that are named.

void check_region(const Json& region) {  // 3.30
  const auto of = [&](const char* key) { return region.at(key).get<int>(); };
  EXPECT_GE(of("startLine"), 1);
  EXPECT_GE(of("startColumn"), 1);
  EXPECT_GE(of("endLine"), of("startLine"));
  if (of("endLine") == of("startLine")) {
    EXPECT_GE(of("endColumn"), of("startColumn"));
  }
  EXPECT_GE(of("endColumn"), 1);
}

void check_artifact_location(const Json& location, const Json& run) {  // 3.4
  const auto uri = location.at("uri").get<std::string>();
  for (const char c : uri) EXPECT_TRUE(c > ' ' && c < 0x7F && c != '<' && c != '"') << uri;
  const auto index = location.at("index").get<std::size_t>();
  EXPECT_EQ(run.at("artifacts").at(index).at("location").at("uri"), uri);
}

void check_location(const Json& location, const Json& run) {  // 3.28, 3.29
  check_artifact_location(location.at("physicalLocation").at("artifactLocation"), run);
  check_region(location.at("physicalLocation").at("region"));
}

void check_result(const Json& result, const Json& run) {  // 3.27
  const auto index = result.at("ruleIndex").get<std::size_t>();
  EXPECT_EQ(run.at("tool").at("driver").at("rules").at(index).at("id"), result.at("ruleId"));
  const std::set<std::string> levels = {"none", "note", "warning", "error"};
  EXPECT_TRUE(levels.contains(result.at("level")));
  EXPECT_FALSE(result.at("message").at("text").get<std::string>().empty());
  ASSERT_EQ(result.at("locations").size(), 1U);
  check_location(result.at("locations").at(0), run);
  for (const Json& related : result.value("relatedLocations", Json::array())) {
    EXPECT_FALSE(related.at("message").at("text").get<std::string>().empty());
    check_location(related, run);
  }
  for (const Json& fix : result.value("fixes", Json::array())) {  // 3.55 to 3.57
    ASSERT_FALSE(fix.at("artifactChanges").empty());
    for (const Json& change : fix.at("artifactChanges")) {
      check_artifact_location(change.at("artifactLocation"), run);
      ASSERT_FALSE(change.at("replacements").empty());
      for (const Json& replacement : change.at("replacements")) {
        check_region(replacement.at("deletedRegion"));
        EXPECT_TRUE(replacement.at("insertedContent").at("text").is_string());
      }
    }
  }
}

// The one run of a log in order.
Json checked_run(const std::string& log) {
  const Json parsed = Json::parse(log);
  EXPECT_EQ(parsed.at("version"), "2.1.0");  // 3.13
  EXPECT_EQ(parsed.at("$schema"), "https://json.schemastore.org/sarif-2.1.0.json");
  EXPECT_EQ(parsed.at("runs").size(), 1U);
  Json run = parsed.at("runs").at(0);  // 3.14
  EXPECT_EQ(run.at("columnKind"), "unicodeCodePoints");
  EXPECT_EQ(run.at("tool").at("driver").at("name"), "dgt");  // 3.19
  std::set<std::string> ids;
  for (const Json& rule : run.at("tool").at("driver").at("rules")) {  // 3.49
    EXPECT_TRUE(ids.insert(rule.at("id")).second);
    EXPECT_EQ(rule.at("messageStrings").at("en"), rule.at("fullDescription"));
    EXPECT_EQ(rule.at("messageStrings").at("ru"), rule.at("help"));
  }
  for (const Json& result : run.at("results")) check_result(result, run);
  return run;
}

Json region_of(const Range& range) {
  DiagnosticBag bag;
  bag.add({Message::Unexpected, range, {"x"}});
  return checked_run(to_sarif(bag))["results"][0]["locations"][0]["physicalLocation"]["region"];
}

std::string uri_of(const std::string& name) {
  const SourceFile file(name, "L");
  DiagnosticBag bag;
  bag.add({Message::MissingNumber, {&file, 0, 1}, {"L"}});
  return checked_run(to_sarif(bag))["artifacts"][0]["location"]["uri"];
}

TEST(Sarif, ALogWithoutDiagnosticsHasEmptyLists) {
  const Json run = checked_run(to_sarif(DiagnosticBag(), {Language::English, "1.2.3"}));
  EXPECT_TRUE(run["results"].is_array() && run["results"].empty());
  EXPECT_TRUE(run["artifacts"].empty());
  EXPECT_EQ(run["tool"]["driver"]["version"], "1.2.3");
}

TEST(Sarif, AResultHoldsRuleLevelMessagePlaceNotesAndFix) {
  const SourceFile program("p.bgt", "' деталь\n\tС2 Р14 L5\n");
  const SourceFile macro("mac/m.mac", "L1=\n");
  const auto begin = static_cast<std::uint32_t>(program.text().find("Р14"));
  const Range range{&program, begin, begin + 4};
  DiagnosticBag bag;
  bag.add({Message::LookAlike,
           range,
           {"Р14", "P14"},
           {{Message::EmptyDefinition, {&macro, 0, 3}, {"L1"}}},
           FixIt{{&program, begin, begin + 2}, "P"}});
  const Json run = checked_run(to_sarif(bag));
  EXPECT_EQ(run["language"], "en");
  EXPECT_EQ(run["results"], Json::parse(R"json([{
    "ruleId": "DGT0103", "ruleIndex": 0, "level": "warning",
    "message": {"text": "'Р14' typed in Cyrillic, read as 'P14'", "id": "en",
                "arguments": ["Р14", "P14"]},
    "locations": [{"physicalLocation": {
      "artifactLocation": {"uri": "p.bgt", "index": 0},
      "region": {"startLine": 2, "startColumn": 5, "endLine": 2, "endColumn": 8}}}],
    "relatedLocations": [{
      "physicalLocation": {
        "artifactLocation": {"uri": "mac/m.mac", "index": 1},
        "region": {"startLine": 1, "startColumn": 1, "endLine": 1, "endColumn": 4}},
      "message": {"text": "nothing defines L1"}}],
    "fixes": [{"artifactChanges": [{
      "artifactLocation": {"uri": "p.bgt", "index": 0},
      "replacements": [{
        "deletedRegion": {"startLine": 2, "startColumn": 5, "endLine": 2, "endColumn": 6},
        "insertedContent": {"text": "P"}}]}]}]
  }])json"));
}

TEST(Sarif, RulesCarryBothLanguagesAndStandOnce) {
  const SourceFile file("a.bgt", "LC");
  DiagnosticBag bag;
  bag.add({Message::MissingNumber, {&file, 0, 1}, {"L"}});
  bag.add({Message::MissingNumber, {&file, 1, 2}, {"C"}});
  const Json run = checked_run(to_sarif(bag, {Language::Russian, ""}));
  EXPECT_EQ(run["tool"]["driver"], Json::parse(R"json({"name": "dgt", "rules": [{
    "id": "DGT0202", "name": "MissingNumber",
    "fullDescription": {"text": "'{0}' needs a number"},
    "help": {"text": "после «{0}» нужно число"},
    "messageStrings": {"en": {"text": "'{0}' needs a number"},
                       "ru": {"text": "после «{0}» нужно число"}},
    "defaultConfiguration": {"level": "error"}}]})json"));
  EXPECT_EQ(run["results"][1]["message"], Json::parse(R"json(
    {"text": "после «C» нужно число", "id": "ru", "arguments": ["C"]})json"));
}

TEST(Sarif, SeveralBagsMakeOneRunAndOneListOfFiles) {
  const SourceFile first("a.bgt", "L");
  const SourceFile macro("m.mac", "C", Encoding::Cp866);
  const SourceFile macro_again("m.mac", "C", Encoding::Cp866);
  DiagnosticBag one;
  one.add({Message::MissingNumber, {&first, 0, 1}, {"L"}});
  one.add({Message::MissingNumber, {&macro, 0, 1}, {"C"}});
  DiagnosticBag two;
  two.add({Message::MissingNumber, {&macro_again, 0, 1}, {"C"}});
  const std::array<const DiagnosticBag*, 2> bags = {&one, &two};
  const Json run = checked_run(to_sarif(bags));
  EXPECT_EQ(run["results"].size(), 3U);
  EXPECT_EQ(run["artifacts"], Json::parse(R"json([
    {"location": {"uri": "a.bgt"}, "encoding": "UTF-8"},
    {"location": {"uri": "m.mac"}, "encoding": "IBM866"}])json"));
}

TEST(Sarif, RegionsCountCodePointsAndMayRunOverLines) {
  const SourceFile file("a.bgt", "жж\r\n😀L1\n");
  EXPECT_EQ(region_of({&file, 2, 11}),
            Json::parse(R"({"startLine": 1, "startColumn": 2, "endLine": 2, "endColumn": 3})"));
  EXPECT_EQ(region_of({&file, 12, 12}),
            Json::parse(R"({"startLine": 2, "startColumn": 4, "endLine": 2, "endColumn": 4})"))
      << "the empty range at the end of a line";
  EXPECT_EQ(region_of({&file, 13, 13}),
            Json::parse(R"({"startLine": 2, "startColumn": 4, "endLine": 2, "endColumn": 4})"))
      << "the end of the file";
}

TEST(Sarif, NamesOfFilesAreUriReferences) {
  EXPECT_EQ(uri_of("parts/a b.bgt"), "parts/a%20b.bgt");
  EXPECT_EQ(uri_of("/tmp/a.bgt"), "file:///tmp/a.bgt");
  EXPECT_EQ(uri_of("Плита.bgt"), "%D0%9F%D0%BB%D0%B8%D1%82%D0%B0.bgt");
  EXPECT_EQ(uri_of("c:a%.bgt"), "c%3Aa%25.bgt");
  EXPECT_EQ(uri_of("<stdin>"), "%3Cstdin%3E");
  EXPECT_EQ(uri_of("\xCF.bgt"), "%CF.bgt") << "a name that is no UTF-8";
}

TEST(Sarif, BracesInAMessageAreDoubledAsThereTheyMeanPlaceholders) {
  const SourceFile file("a.bgt", "{0}");
  DiagnosticBag bag;
  bag.add({Message::UnknownCharacter, {&file, 0, 3}, {"{0}"}});
  const Json run = checked_run(to_sarif(bag));
  EXPECT_EQ(run["results"][0]["message"]["text"], "'{{0}}' has no meaning in the language");
  EXPECT_EQ(run["results"][0]["message"]["arguments"][0], "{0}");
}

TEST(Sarif, ArgumentsThatAreNoTextDoNoHarm) {
  const SourceFile file("a.bgt", "L");
  DiagnosticBag bag;
  bag.add({Message::MissingNumber, {&file, 0, 1}, {"\xFF\x1B"}});
  const Json run = checked_run(to_sarif(bag));
  EXPECT_EQ(run["results"][0]["message"]["arguments"][0], "\uFFFDU+001B");
}

}  // namespace
}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/machine_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace dgt {
namespace {

constexpr std::string_view kBlanks = " \t\r";

/// Turns the parser's lines and columns, which count code points, into bytes.
class Places {
 public:
  explicit Places(std::string_view text) : text_(text) {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') line_starts_.push_back(i + 1);
  }

  [[nodiscard]] std::size_t line_begin(const toml::source_position& at) const {
    return line_starts_[std::clamp<std::size_t>(at.line, 1, line_starts_.size()) - 1];
  }
  [[nodiscard]] std::size_t line_end(std::size_t offset) const {
    return std::min(text_.find('\n', offset), text_.size());
  }
  [[nodiscard]] std::size_t offset(const toml::source_position& at) const {
    std::size_t offset = line_begin(at);
    const std::size_t end = line_end(offset);
    for (toml::source_index column = 1; column < at.column && offset < end; ++column) {
      ++offset;
      while (offset < end && (static_cast<unsigned char>(text_[offset]) & 0xC0) == 0x80) ++offset;
    }
    return offset;
  }
  /// Within one line and without blanks at the ends.
  [[nodiscard]] TextSpan span(std::size_t begin, std::size_t end) const {
    end = std::min(end, line_end(begin));
    while (begin < end && kBlanks.find(text_[begin]) != std::string_view::npos) ++begin;
    while (begin < end && kBlanks.find(text_[end - 1]) != std::string_view::npos) --end;
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  }
  [[nodiscard]] TextSpan span(const toml::source_region& region) const {
    return span(offset(region.begin), offset(region.end));
  }
  [[nodiscard]] std::string text(const TextSpan& span) const {
    return std::string(text_.substr(span.begin, span.end - span.begin));
  }

 private:
  std::string_view text_;
  std::vector<std::size_t> line_starts_{0};
};

/// `1_0.5e-2` as `0.105`: a decimal of the same value, without exponent.
std::string plain_decimal(std::string spelled) {
  std::erase(spelled, '_');
  const std::size_t e = spelled.find_first_of("eE");
  if (e == std::string::npos) return spelled;
  // TOML has made sure of a double, so the exponent is of a few hundred at most.
  const int exponent = std::atoi(spelled.c_str() + e + 1);
  std::string digits = spelled.substr(0, e);
  std::string sign;
  if (digits.front() == '-' || digits.front() == '+') {
    sign = digits.substr(0, 1);
    digits.erase(0, 1);
  }
  int point = static_cast<int>(std::min(digits.find('.'), digits.size())) + exponent;
  std::erase(digits, '.');
  if (point < 1) {
    digits.insert(0, static_cast<std::size_t>(1 - point), '0');
    point = 1;
  }
  const auto whole = static_cast<std::size_t>(point);
  if (digits.size() < whole) digits.resize(whole, '0');
  return sign + digits.insert(whole, digits.size() == whole ? "" : ".");
}

std::optional<std::vector<std::string>> texts_of(const toml::array& list) {
  std::vector<std::string> texts;
  for (const toml::node& node : list) {
    const auto* const text = node.as_string();
    if (text == nullptr) return std::nullopt;
    texts.push_back(text->get());
  }
  return texts;
}

MachineEntry entry_of(std::string key, const toml::key& name, const toml::node& node,
                      const Places& places) {
  using Kind = MachineEntry::Kind;
  MachineEntry entry{std::move(key), Kind::Other, {}, places.span(name.source()), {}};
  entry.value_span = places.span(node.source());
  if (const auto* const text = node.as_string()) {
    entry.kind = Kind::Text;
    entry.values = {text->get()};
  } else if (const auto* const whole = node.as_integer()) {
    entry.kind = Kind::Number;
    entry.values = {std::to_string(whole->get())};
  } else if (node.is_floating_point()) {
    entry.kind = Kind::Number;
    entry.values = {plain_decimal(places.text(entry.value_span))};
  } else if (auto texts = node.is_array() ? texts_of(*node.as_array()) : std::nullopt) {
    entry.kind = Kind::List;
    entry.values = *std::move(texts);
  } else {
    entry.values = {places.text(entry.value_span)};
  }
  return entry;
}

void append_entries(const toml::table& table, const std::string& prefix, const Places& places,
                    std::vector<MachineEntry>& entries) {
  for (const auto& [name, node] : table) {
    std::string key = prefix + std::string(name.str());
    const toml::table* const inner = node.as_table();
    if (inner != nullptr && !inner->empty()) {
      append_entries(*inner, key + ".", places, entries);
    } else {
      entries.push_back(entry_of(std::move(key), name, node, places));
    }
  }
}

MachineSyntaxFault fault_of(const toml::parse_error& error, std::string_view text,
                            const Places& places) {
  const std::size_t line = places.line_begin(error.source().begin);
  const std::size_t end = places.line_end(line);
  if (error.description().find("cannot redefine") != std::string_view::npos) {
    return {MachineSyntaxFault::Kind::KeyTwice,
            places.span(line, std::min(text.find('=', line), end))};
  }
  const TextSpan rest = places.span(places.offset(error.source().begin), end);
  // At the end of a line it is the line that is wrong.
  return {MachineSyntaxFault::Kind::Unreadable,
          rest.begin < rest.end ? rest : places.span(line, end)};
}

}  // namespace

tl::expected<std::vector<MachineEntry>, MachineSyntaxFault> read_machine_text(
    std::string_view text) {
  const Places places(text);
  std::vector<MachineEntry> entries;
  try {
    append_entries(toml::parse(text), "", places, entries);
  } catch (const toml::parse_error& error) {
    return tl::unexpected(fault_of(error, text, places));
  }
  std::ranges::sort(entries, {}, [](const MachineEntry& entry) { return entry.key_span.begin; });
  return entries;
}

}  // namespace dgt

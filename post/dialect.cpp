// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/dialect.h"

#include <algorithm>

namespace dgt {
namespace {

Dialect essi() {
  Dialect d;
  d.name = "essi";
  d.form = Form::Essi;
  d.arc_form = ArcForm::Radius;
  // The middle of a radius-form arc moves by |1 − 1/cos(θ/2)| for each unit of R: 1 at 120°.
  d.max_arc_degrees = 120;
  d.torch_on = "53";
  d.torch_off = "54";
  d.torch_on_codes = {"M3", "M4", "M7", "M53", "53"};
  d.torch_off_codes = {"M5", "M8", "M54", "54"};
  d.codes = {{"M0", "0"}};
  d.passed_numbers_below = 101;  // from there on they call subprograms
  d.dropped_letters = "S";
  return d;
}

Dialect plasmatic() {
  Dialect d;
  d.name = "plasmatic";
  d.header = {"G21", "G91"};
  d.footer = {"M02"};
  d.torch_on = "M07";
  d.torch_off = "M08";
  d.torch_on_codes = {"M3", "M4", "M7", "53"};
  d.torch_off_codes = {"M5", "M8", "54"};
  d.codes = {{"M0", "M00"}, {"0", "M00"}};
  d.dropped_letters = "S";
  d.writes_feed = true;
  d.dwell_word = "G04 X";
  return d;
}

Dialect linuxcnc() {
  Dialect d;
  d.name = "linuxcnc";
  d.positions = Positions::Absolute;
  d.unit = Rational(1, 1000);
  // LinuxCNC and GRBL accept more; what keeps to one step is accepted everywhere.
  d.radius_mismatch = Rational(1, 1000);
  // Below RADIUS_TOLERANCE_MM, 0.00005 inch, LinuxCNC refuses a "Zero-radius arc".
  d.least_radius = Rational(127, 100000);
  d.header = {"G21 G90 G17 G40 G91.1"};
  d.footer = {"M02"};
  d.torch_on = "M07";
  d.torch_off = "M08";
  d.torch_on_codes = {"M7", "53"};
  d.torch_off_codes = {"M8", "54"};
  d.own_torch_codes = {"M3", "M4", "M5"};
  d.codes = {{"0", "M0"}};
  d.passed_letters = "MST";
  d.writes_feed = true;
  d.needs_feed = true;
  d.writes_height = true;
  d.dwell_word = "G04 P";
  return d;
}

/// `M07` as `M7`.
std::string without_leading_zeros(std::string_view code) {
  const std::size_t digits = code.find_first_of("0123456789");
  if (digits == std::string_view::npos) return std::string(code);
  const std::size_t first = std::min(code.find_first_not_of('0', digits), code.size());
  const bool number = first < code.size() && code[first] >= '0' && code[first] <= '9';
  return std::string(code.substr(0, digits)) +
         std::string(code.substr(number ? first : first - (first > digits ? 1 : 0)));
}

bool contains(const std::vector<std::string>& list, const std::string& code) {
  return std::find(list.begin(), list.end(), code) != list.end();
}

bool is_number_below(const std::string& code, int limit) {
  if (code.empty() || code.size() > 6) return false;
  if (code.find_first_not_of("0123456789") != std::string::npos) return false;
  return std::stoi(code) < limit;
}

}  // namespace

const std::vector<Dialect>& dialects() {
  static const std::vector<Dialect> all{essi(), plasmatic(), linuxcnc()};
  return all;
}

const Dialect* find_dialect(std::string_view name) {
  for (const Dialect& d : dialects())
    if (d.name == name) return &d;
  return nullptr;
}

CodeMeaning meaning_of(const Dialect& dialect, std::string_view code) {
  using Kind = CodeMeaning::Kind;
  const std::string plain = without_leading_zeros(code);
  if (contains(dialect.torch_on_codes, plain)) return {Kind::TorchOn, dialect.torch_on, true};
  if (contains(dialect.torch_off_codes, plain)) return {Kind::TorchOff, dialect.torch_off, true};
  if (plain == "M2" || plain == "M30") return {Kind::End, "", false};
  for (const CodeWord& word : dialect.codes)
    if (word.code == plain) return {Kind::Words, word.words, false};
  if (is_number_below(plain, dialect.passed_numbers_below)) return {Kind::Words, plain, false};
  if (!plain.empty() && dialect.dropped_letters.find(plain.front()) != std::string::npos)
    return {Kind::Dropped, "", false};
  if (!plain.empty() && dialect.passed_letters.find(plain.front()) != std::string::npos)
    return {Kind::Words, plain, contains(dialect.own_torch_codes, plain)};
  return {};
}

}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/fixes.h"

#include <algorithm>
#include <utility>

namespace dgt {
namespace {

bool is_applicable(const Diagnostic& d, const SourceFile& file) {
  return d.severity() != Severity::Note && d.fix_it && d.fix_it->range.file == &file &&
         d.fix_it->certainty == Certainty::Sure;
}

}  // namespace

FixedText apply_fixes(const SourceFile& file, const DiagnosticBag& bag) {
  std::vector<const Diagnostic*> fixes;
  for (const Diagnostic& d : bag.all()) {
    if (is_applicable(d, file)) fixes.push_back(&d);
  }
  std::ranges::stable_sort(fixes, {}, [](const Diagnostic* d) {
    return std::pair(d->fix_it->range.begin, d->fix_it->range.end);
  });
  FixedText fixed;
  const std::string_view text = file.text();
  std::uint32_t done = 0;  // up to here the text has been taken over
  for (const Diagnostic* const d : fixes) {
    const Range range = d->fix_it->range;
    const bool same_place =
        !fixed.applied.empty() && fixed.applied.back()->fix_it->range.begin == range.begin;
    if (range.begin < done || same_place) continue;
    fixed.text += text.substr(done, range.begin - done);
    fixed.text += d->fix_it->replacement;
    fixed.applied.push_back(d);
    done = range.end;
  }
  fixed.text += text.substr(done);
  return fixed;
}

}  // namespace dgt

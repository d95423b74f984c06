// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/fixing.h"

#include "kernel/check.h"
#include "lang/text/fixes.h"

namespace dgt {
namespace {

void note_repairs(const FixedText& fixed, std::vector<Repair>& repairs) {
  for (const Diagnostic* const d : fixed.applied) {
    const Range& range = d->fix_it->range;
    repairs.push_back(
        {d->message, range.place(), std::string(range.text()), d->fix_it->replacement});
  }
}

}  // namespace

FileResult<Fixing> fix_file(const std::string& name, const SourceSettings& settings) {
  auto bytes = read_file(name);
  if (!bytes) return tl::unexpected(bytes.error());
  Fixing fixing{{}, *std::move(bytes), {}};
  fixing.made = compile_bytes(name, fixing.bytes, settings);
  if (fixing.made.file->is_utf16() || !fixing.made.file->strays().empty()) return fixing;
  // Fewer Cyrillic letters may make the encoding look like another.
  SourceSettings same_encoding = settings;
  same_encoding.encoding = fixing.made.file->form().encoding;
  for (int round = 0; round < kMaxFixRounds; ++round) {
    const FixedText fixed = apply_fixes(*fixing.made.file, fixing.made.bag);
    if (fixed.applied.empty()) break;
    note_repairs(fixed, fixing.repairs);
    Encoded encoded = encode(fixed.text, fixing.made.file->form());
    DGT_CHECK(encoded.lost.empty());  // replacements are ASCII
    fixing.bytes = std::move(encoded.bytes);
    fixing.made = compile_bytes(name, fixing.bytes, same_encoding);
  }
  return fixing;
}

}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/control_proof.h"

#include <optional>

#include "apps/driver/nc_files.h"

namespace dgt {
namespace {

void raise(Peak& peak, const Peak& other) {
  if (other.value > peak.value) peak = other;
}

/// Of two proofs that hold; the blocks are told of the first.
void join(Certificate& proof, const Certificate& other) {
  proof.leads.insert(proof.leads.end(), other.leads.begin(), other.leads.end());
  raise(proof.deviation, other.deviation);
  raise(proof.error_x, other.error_x);
  raise(proof.error_y, other.error_y);
  raise(proof.control_error, other.control_error);
  raise(proof.mismatch, other.mismatch);
}

std::optional<Certificate> prove_both_ways(const Compiled& program, const Compilation& against,
                                           const Dialect& dialect, const VerifyLimits& limits,
                                           const OnProgress& on_progress) {
  std::optional<Certificate> proof;
  for (const KerfLead lead : {KerfLead::Meets, KerfLead::Beside}) {
    SourceSettings settings = program.settings;
    set_kerf_lead(settings, lead);
    const Compilation read = compile_source(program.name, program.made.file, settings);
    if (!read.result.path) return std::nullopt;
    const Certificate one = verify(read, against, dialect.name, limits, on_progress, lead);
    if (!one.holds()) return one;
    if (proof) {
      join(*proof, one);
    } else {
      proof = one;
    }
  }
  return proof;
}

}  // namespace

Certificate prove(const Compiled& program, const Compiled& against, const Dialect& dialect,
                  const VerifyLimits& limits, const OnProgress& on_progress) {
  const KerfLead lead = program.settings.gcode.nc.kerf_lead;
  if (!program.made.has_kerf)
    return verify(program.made, against.made, dialect.name, limits, on_progress);
  std::optional<Compilation> rounded;
  if (dialect.kerf.rounds_corners) {
    SourceSettings settings = against.settings;
    settings.evaluate.corner = CornerStyle::Round;
    rounded = compile_source(against.name, against.made.file, settings);
  }
  const Compilation& exact = rounded && rounded->result.path ? *rounded : against.made;
  if (dialect.kerf.exist() && lead == KerfLead::Moved) {
    auto proof = prove_both_ways(program, exact, dialect, limits, on_progress);
    if (proof) return *std::move(proof);
  }
  return verify(program.made, exact, dialect.name, limits, on_progress, lead);
}

}  // namespace dgt

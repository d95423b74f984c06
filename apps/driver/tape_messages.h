// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>

#include "device/compare.h"
#include "device/decode.h"
#include "device/encode.h"
#include "lang/text/diagnostic.h"

/// What punching and reading have to say, as diagnostics in the program's text.
namespace dgt {

/// What the tape lacks of the program.
[[nodiscard]] DiagnosticBag explain(const EncodedTape& tape, const SourceFile& program);

/// A tape's program as a text to point into, with what is wrong with the tape. Rows are told
/// from 1.
struct TapeProgram {
  DecodedTape decoded;
  std::shared_ptr<const SourceFile> file;
  DiagnosticBag bag;  ///< points into `file`
};
[[nodiscard]] TapeProgram read_program(const std::string& name, const Tape& tape,
                                       const TapeFormat& format);

/// What is different on the tape `found`, of which the rows before `found_from` do not count, from
/// the rows that are wanted. `program` is what read_program() made of `found`.
[[nodiscard]] DiagnosticBag compare(std::span<const Row> wanted, const Tape& found,
                                    std::size_t found_from, const TapeProgram& program,
                                    const TapeFormat& format);

}  // namespace dgt

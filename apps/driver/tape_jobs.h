// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/driver/tape_settings.h"
#include "device/run.h"
#include "lang/text/diagnostic.h"
#include "lang/text/encoding.h"

/// The steps that punching and reading tapes are made of, without a word to the person.
namespace dgt {

/// The format of the tape of a program of that name (`-`: it has none), with `header` as lettering
/// unless that is empty. Nothing when lettering or a checksum is asked for without the `%` behind
/// which they would stand.
[[nodiscard]] std::optional<TapeFormat> format_for(const TapeSettings& settings,
                                                   const std::string& program,
                                                   const std::string& header = {});

/// A program on its way onto tape.
struct ProgramOnTape {
  std::shared_ptr<const SourceFile> file;
  DiagnosticBag reading;   ///< what is wrong with the text; points into `file`
  DiagnosticBag punching;  ///< what the tape lacks of it
  std::vector<Row> rows;   ///< empty when one of the two has errors
};
[[nodiscard]] ProgramOnTape program_on_tape(const std::string& name, std::string_view bytes,
                                            std::optional<Encoding> encoding,
                                            const TapeFormat& format);

/// The text of a tape with the line ends of a file.
[[nodiscard]] std::string with_line_ends(const std::string& text, const std::string& line_end);

/// One reading of the tape in a device.
[[nodiscard]] TapeReading read_from(const ReaderSettings& settings, const TapeFormat& format,
                                    const Watch& watch = {});

/// What is punched when an earlier punching went up to the row before `from` (from 0): blank tape
/// to be spliced, then the rest.
[[nodiscard]] std::vector<Row> rest_of(const std::vector<Row>& rows, std::size_t from,
                                       const TapeFormat& format);

/// As much of a tape that was not punched to its end as can be used.
struct WholeBlocks {
  std::size_t rows = 0;   ///< up to the end of a block
  std::size_t lines = 0;  ///< of the program
};
/// Punches the rows from `from` on, behind blank tape to be spliced where that is not 0; the row of
/// a failure is counted on the whole tape.
[[nodiscard]] tl::expected<void, PunchFailure> punch_from(const PunchSettings& settings,
                                                          const std::vector<Row>& rows,
                                                          std::size_t from,
                                                          const TapeFormat& format,
                                                          const Watch& watch = {});
/// What is whole of a tape of `rows` that was punched from row `from` to the failure; nothing: it
/// has to be begun anew.
[[nodiscard]] std::optional<WholeBlocks> whole_blocks(std::span<const Row> rows,
                                                      const PunchFailure& failure, std::size_t from,
                                                      const TapeFormat& format);

/// `OUT.part.txt`, or with a number when there is one already; where what was read of a tape is
/// kept that should have become `output`.
[[nodiscard]] std::string free_part_name(const std::string& output);

}  // namespace dgt

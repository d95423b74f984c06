// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/tape_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dgt {
namespace {

Range at(const SourceFile& file, std::size_t begin, std::size_t end) {
  const std::size_t size = file.text().size();
  return {&file, static_cast<std::uint32_t>(std::min(begin, size)),
          static_cast<std::uint32_t>(std::min(end, size))};
}

/// The character that begins at `offset`; nothing at the end of a line.
Range character_at(const SourceFile& file, std::size_t offset) {
  if (offset >= file.text().size() || file.text()[offset] == '\n') return at(file, offset, offset);
  return at(file, offset, offset + code_point_at(file.text(), offset).size);
}

/// Rows are told from 1.
std::string number(std::size_t row) { return std::to_string(row + 1); }

Diagnostic diagnostic_of(const TapeFault& fault, const SourceFile& file) {
  using Kind = TapeFault::Kind;
  const Range range = character_at(file, fault.offset);
  const Range nowhere = at(file, 0, 0);
  const std::string row = number(fault.row);
  const std::string distance = millimetres_to(fault.row);
  const auto crc = [](const TapeSum& sum) { return fmt::format("{:08X}", sum.crc); };
  switch (fault.kind) {
    case Kind::Parity:
      return {Message::TapeParity, range, {row, distance, holes_of(fault.seen)}};
    case Kind::Gap:
      return {Message::TapeGap, range, {std::to_string(fault.row), distance, fault.detail}};
    case Kind::NothingPunched:
      return {Message::TapeEmpty, nowhere, {}};
    case Kind::NoStart:
      return {Message::TapeNoStart, nowhere, {row, distance}};
    case Kind::StrayRows:
      return {Message::TapeStrayRows, nowhere, {row, distance, std::to_string(fault.count)}};
    case Kind::ChecksumDiffers:
      return {Message::TapeSumDiffers,
              nowhere,
              {crc(fault.said), std::to_string(fault.said.count), crc(fault.found),
               std::to_string(fault.found.count)}};
    case Kind::ChecksumMissing:
      return {Message::TapeSumMissing, nowhere, {}};
    case Kind::ForeignCode:
      break;
  }
  return {Message::TapeForeignCode,
          range,
          {row, distance, name_of(fault.seen), std::to_string(fault.count)}};
}

/// The words of one line as one, with what stands between them.
std::vector<UnpunchableRun> line_by_line(const std::vector<UnpunchableRun>& runs,
                                         std::string_view text) {
  std::vector<UnpunchableRun> lines;
  for (const UnpunchableRun& run : runs) {
    const std::size_t end = lines.empty() ? 0 : lines.back().end;
    const std::string_view between = text.substr(end, run.begin - end);
    if (lines.empty() || lines.back().refused != run.refused ||
        between.find_first_of("\r\n") != std::string_view::npos) {
      lines.push_back(run);
      continue;
    }
    lines.back().end = run.end;
    const bool is_dropped = lines.back().replacement.empty() && run.replacement.empty();
    if (!is_dropped) lines.back().replacement.append(between).append(run.replacement);
  }
  return lines;
}

/// Strange rows before the `%` all stand before the text: told once, with their number.
std::vector<TapeFault> in_one_place(const std::vector<TapeFault>& faults) {
  std::vector<TapeFault> told;
  for (const TapeFault& fault : faults) {
    const auto before = std::ranges::find(told, fault.kind, &TapeFault::kind);
    if (fault.kind == TapeFault::Kind::StrayRows && before != told.end()) {
      before->count += fault.count;
    } else {
      told.push_back(fault);
    }
  }
  return told;
}

std::string shown(Row row) {
  return has_even_parity(row) ? name_of(row) : "[" + holes_of(row) + "]";
}

/// Rows that are missing or too many beside each other are told together.
struct DifferentRows {
  RowDifference first;
  std::string names;  // of what is missing, else of what was found
};

bool goes_on(const RowDifference& before, const RowDifference& next) {
  using Kind = RowDifference::Kind;
  if (before.kind != next.kind || before.kind == Kind::Changed) return false;
  return before.kind == Kind::Missing
             ? next.wanted_row == before.wanted_row + 1 && next.found_row == before.found_row
             : next.found_row == before.found_row + 1;
}

std::vector<DifferentRows> together(const std::vector<RowDifference>& rows) {
  std::vector<DifferentRows> all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string name =
        shown(rows[i].kind == RowDifference::Kind::Missing ? rows[i].wanted : rows[i].found);
    if (i > 0 && goes_on(rows[i - 1], rows[i])) {
      all.back().names += " " + name;
    } else {
      all.push_back({rows[i], name});
    }
  }
  return all;
}

Diagnostic diagnostic_of(const DifferentRows& different, Range range) {
  const RowDifference& first = different.first;
  const std::string row = number(first.found_row);
  const std::string distance = millimetres_to(first.found_row);
  switch (first.kind) {
    case RowDifference::Kind::Changed:
      return {Message::RowChanged, range, {row, distance, different.names, shown(first.wanted)}};
    case RowDifference::Kind::Missing:
      return {Message::RowMissing, range, {row, distance, different.names}};
    case RowDifference::Kind::Extra:
      break;
  }
  return {Message::RowExtra, range, {row, distance, different.names}};
}

/// Where in the program's text a row of its tape stands: behind what the rows before it say.
std::size_t offset_of(std::size_t row, const Tape& tape, const TapeProgram& program,
                      const TapeFormat& format) {
  const DecodedTape& whole = program.decoded;
  if (row <= whole.program_begin) return 0;
  if (row >= whole.program_end) return whole.text.size();
  const Tape before{{tape.rows.begin(), tape.rows.begin() + static_cast<std::ptrdiff_t>(row)}, {}};
  const DecodedTape part = decode_tape(before, format);
  // The beginning of a pair of % lines looks like a start while its end is not there.
  const bool lost_start = whole.text.starts_with("%\n") && !part.text.starts_with("%\n");
  return std::min(whole.text.size(), part.text.size() + (lost_start ? 2 : 0));
}

/// So many differences have their place in the text looked for; it costs a reading each.
constexpr std::size_t kMostPlaces = 100;

}  // namespace

DiagnosticBag explain(const EncodedTape& tape, const SourceFile& program) {
  DiagnosticBag bag;
  for (const UnpunchableRun& run : line_by_line(tape.unpunchable, program.text())) {
    const Range range = at(program, run.begin, run.end);
    const std::string seen(range.text());
    if (run.refused) {
      bag.add({Message::CannotPunch, range, {seen}});
    } else if (run.replacement.empty()) {
      bag.add({Message::NotPunched, range, {seen}});
    } else {
      bag.add({Message::PunchedAs, range, {seen, run.replacement}});
    }
  }
  if (tape.ends_in_line) {
    const std::size_t end = program.text().size();
    bag.add({Message::LastLineOpen, at(program, end, end), {}});
  }
  return bag;
}

TapeProgram read_program(const std::string& name, const Tape& tape, const TapeFormat& format) {
  TapeProgram program;
  program.decoded = decode_tape(tape, format);
  program.file = std::make_shared<const SourceFile>(name, program.decoded.text, Encoding::Utf8);
  for (const TapeFault& fault : in_one_place(program.decoded.faults)) {
    program.bag.add(diagnostic_of(fault, *program.file));
  }
  const std::size_t told = program.decoded.faults.size();
  if (told == DecodedTape::kMostFaults && program.decoded.damage_count > told) {
    program.bag.add({Message::TooManyDiagnostics,
                     at(*program.file, program.file->text().size(), program.file->text().size()),
                     {std::to_string(DecodedTape::kMostFaults)}});
  }
  return program;
}

DiagnosticBag compare(std::span<const Row> wanted, const Tape& found, std::size_t found_from,
                      const TapeProgram& program, const TapeFormat& format) {
  const auto rows = std::span<const Row>(found.rows).subspan(found_from);
  TapeDifferences differences = compare_rows(wanted, rows);
  for (RowDifference& row : differences.rows) row.found_row += found_from;
  DiagnosticBag bag;
  std::size_t places = 0;
  for (const DifferentRows& different : together(differences.rows)) {
    const std::size_t offset = places++ < kMostPlaces
                                   ? offset_of(different.first.found_row, found, program, format)
                                   : program.decoded.text.size();
    bag.add(diagnostic_of(different, character_at(*program.file, offset)));
  }
  return bag;
}

}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/tape_jobs.h"

#include <algorithm>
#include <filesystem>

#include "apps/driver/file_io.h"
#include "apps/driver/pipeline.h"
#include "apps/driver/tape_messages.h"
#include "lang/text/reading.h"

namespace dgt {
namespace {

/// The row behind the last line end among the first `count`.
std::size_t behind_last_block(std::span<const Row> rows, std::size_t count) {
  while (count > 0 && rows[count - 1] != kLineFeed) --count;
  return count;
}

}  // namespace

std::optional<TapeFormat> format_for(const TapeSettings& settings, const std::string& program,
                                     const std::string& header) {
  TapeFormat format = settings.format;
  if (!header.empty()) {
    format.header = header;
  } else if (settings.header_is_name && program != kStream) {
    format.header = std::filesystem::path(program).filename().string();
  }
  const bool needs_start = !format.header.empty() || format.checksum == TapeChecksum::Line;
  if (needs_start && format.start == TapeStart::None) return std::nullopt;
  return format;
}

ProgramOnTape program_on_tape(const std::string& name, std::string_view bytes,
                              std::optional<Encoding> encoding, const TapeFormat& format) {
  ProgramOnTape made;
  made.file = decode_source(name, bytes, encoding);
  report_reading(*made.file, made.reading);
  EncodedTape tape = encode_tape(made.file->text(), format);
  made.punching = explain(tape, *made.file);
  if (!made.reading.has_errors() && !made.punching.has_errors()) made.rows = std::move(tape.rows);
  return made;
}

std::string with_line_ends(const std::string& text, const std::string& line_end) {
  if (line_end == "\n") return text;
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    if (c == '\n') {
      out += line_end;
    } else {
      out += c;
    }
  }
  return out;
}

TapeReading read_from(const ReaderSettings& settings, const TapeFormat& format,
                      const Watch& watch) {
  const auto reader = open_reader(settings);
  if (!reader) return {{}, reader.error()};
  return read_tape(**reader, settings, format, watch);
}

std::vector<Row> rest_of(const std::vector<Row>& rows, std::size_t from, const TapeFormat& format) {
  if (from == 0) return rows;
  std::vector<Row> rest(rows_in(format.leader), kBlankRow);
  rest.insert(rest.end(), rows.begin() + static_cast<std::ptrdiff_t>(from), rows.end());
  return rest;
}

tl::expected<void, PunchFailure> punch_from(const PunchSettings& settings,
                                            const std::vector<Row>& rows, std::size_t from,
                                            const TapeFormat& format, const Watch& watch) {
  auto punch = open_punch(settings);
  if (!punch) return tl::unexpected(PunchFailure{punch.error(), 0});
  const std::vector<Row> rest = rest_of(rows, from, format);
  auto done = punch_tape(**punch, rest, settings, watch);
  if (!done) {
    std::size_t& punched = done.error().punched;
    punched += rows.size();
    punched -= std::min(punched, rest.size());
  }
  return done;
}

std::optional<WholeBlocks> whole_blocks(std::span<const Row> rows, const PunchFailure& failure,
                                        std::size_t from, const TapeFormat& format) {
  const std::size_t whole = behind_last_block(rows, std::min(failure.punched, rows.size()));
  if (whole <= from) return std::nullopt;
  const Tape before{{rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(whole)}, {}};
  const auto lines = std::ranges::count(decode_tape(before, format).text, '\n');
  return WholeBlocks{whole, static_cast<std::size_t>(lines)};
}

std::string free_part_name(const std::string& output) {
  const std::string stem = output == kStream ? "tape" : output;
  std::string name = stem + ".part.txt";
  for (int i = 2; std::filesystem::exists(name); ++i) {
    name = stem + ".part-" + std::to_string(i) + ".txt";
  }
  return name;
}

}  // namespace dgt

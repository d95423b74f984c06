// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a tape, as a picture of one and as a program to be punched. The first byte chooses
// the format.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "apps/driver/tape_images.h"
#include "apps/driver/tape_messages.h"
#include "device/compare.h"
#include "device/join.h"
#include "kernel/check.h"
#include "lang/text/render.h"

namespace {

using namespace dgt;

TapeFormat format_of(std::uint8_t choice) {
  TapeFormat format;
  format.leader = format.trailer = choice & 31;
  if ((choice & 32) != 0) format.start = TapeStart::None;
  if ((choice & 64) != 0) format.before_start = BeforeStart::Ignored;
  if ((choice & 96) == 0 && (choice & 128) != 0) {
    format.checksum = TapeChecksum::Line;
    format.header = "A-1";
  }
  format.unpunchable = (choice & 128) != 0 ? Unpunchable::Transliterate : Unpunchable::Drop;
  return format;
}

void check_reading(const Tape& tape, const TapeFormat& format) {
  const TapeProgram program = read_program("f.tap", tape, format);
  const DecodedTape& decoded = program.decoded;
  DGT_CHECK(decoded.program_begin <= decoded.program_end);
  DGT_CHECK(decoded.program_end <= tape.rows.size());
  for (const TapeFault& fault : decoded.faults) {
    DGT_CHECK(fault.row <= tape.rows.size());
    DGT_CHECK(fault.offset <= decoded.text.size());
  }
  (void)render(program.bag, {Language::Russian, Colour::Ansi});
  // Where parity is wrong behind the start, it is told.
  std::size_t odd = 0;
  for (std::size_t i = decoded.program_begin; i < decoded.program_end; ++i) {
    odd += has_even_parity(tape.rows[i]) ? 0 : 1;
  }
  DGT_CHECK(odd <= decoded.damage_count);
  DGT_CHECK(from_picture(to_picture(tape)).value().rows == tape.rows);
  DGT_CHECK(compare_rows(tape.rows, tape.rows).count == 0);
  (void)join_readings(tape, tape);
}

/// What can be punched comes back, but for a `%` alone on the first or the last line.
void check_punching(std::string_view text, const TapeFormat& format) {
  const EncodedTape made = encode_tape(text, format);
  DGT_CHECK(made.refused == made.rows.empty() || format.leader + format.trailer == 0);
  if (made.refused) return;
  const DecodedTape read = decode_tape({made.rows, {}}, format);
  const bool says_nothing = read.program_begin == read.program_end;
  DGT_CHECK(says_nothing || !read.is_damaged());
  TapeFormat plain;
  plain.start = TapeStart::None;
  const std::string once = decode_tape({encode_tape(read.text, plain).rows, {}}, plain).text;
  DGT_CHECK(once == read.text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const TapeFormat format = format_of(data[0]);
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  check_reading({{bytes.begin(), bytes.end()}, {}}, format);
  const TapeImage image = read_tape_image("f.txt", bytes);
  if (!image.bag.has_errors()) check_reading(image.tape, format);
  if (const auto picture = from_picture(bytes)) check_reading(*picture, format);
  check_punching(bytes, format);
  return 0;
}

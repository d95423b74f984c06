// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/iso7.h"

namespace dgt {

RowKind kind_of(Row row) {
  if (!has_even_parity(row)) return RowKind::Damaged;
  switch (row) {
    case kBlankRow:
      return RowKind::Blank;
    case kRubOut:
      return RowKind::RubOut;
    case kLineFeed:
      return RowKind::LineFeed;
    case kCarriageReturn:
      return RowKind::CarriageReturn;
    default:
      return is_punchable(code_of(row)) ? RowKind::Character : RowKind::Foreign;
  }
}

std::string holes_of(Row row) {
  std::string tracks;
  for (std::size_t track = 1; track <= kTracks; ++track) {
    if ((row >> (track - 1) & 1) == 0) continue;
    if (!tracks.empty()) tracks += ' ';
    tracks += static_cast<char>('0' + track);
  }
  return tracks;
}

std::string name_of(Row row) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  switch (kind_of(row)) {
    case RowKind::Blank:
      return "NUL";
    case RowKind::RubOut:
      return "DEL";
    case RowKind::LineFeed:
      return "LF";
    case RowKind::CarriageReturn:
      return "CR";
    case RowKind::Character:
      if (row == kTab) return "HT";
      return code_of(row) == ' ' ? "SP" : std::string(1, code_of(row));
    case RowKind::Foreign:
      if (code_of(row) >= ' ') return {code_of(row)};
      return {'0', 'x', kDigits[code_of(row) >> 4], kDigits[code_of(row) & 15]};
    case RowKind::Damaged:
      break;
  }
  return "?";
}

}  // namespace dgt

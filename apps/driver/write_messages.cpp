// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/write_messages.h"

#include <fmt/format.h>

#include <cmath>

#include "lang/text/column.h"

namespace dgt {
namespace {

const SourceFile& file_of(const SourcePlace& place, const Compilation& program) {
  const std::string& name = program.result.path->files.at(place.file);
  for (const auto& file : program.result.files) {
    if (file->name() == name) return *file;
  }
  return *program.file;
}

/// What belongs to no move is told at the beginning of the program.
Range range_of(const SourcePlace& place, const Compilation& program) {
  if (place.line == 0) return {program.file.get(), 0, 0};
  const SourceFile& file = file_of(place, program);
  const std::uint32_t offset = byte_at(file, place.line, place.column);
  return {&file, offset, offset};
}

/// With three decimals at most.
std::string millimetres(double value) {
  constexpr int kDecimals = 3;
  return to_short_decimal(Rational(value), kDecimals);
}

Diagnostic diagnostic_of(const WriteFault& fault, const Dialect& dialect, Range range) {
  switch (fault.kind) {
    case WriteFault::Kind::UnknownCode:
      return {Message::CodeNotInDialect, range, {fault.code, dialect.name}};
    case WriteFault::Kind::HeightImpossible:
      return {Message::HeightNotInDialect, range, {dialect.name}};
    case WriteFault::Kind::DwellImpossible:
      return {Message::DwellNotInDialect, range, {dialect.name}};
    case WriteFault::Kind::OutOfRange:
      return {Message::TooLargeForDialect, range, {to_short_decimal(dialect.unit)}};
    case WriteFault::Kind::BeyondLargest:
      return {Message::BeyondLargest, range, {dialect.name, to_short_decimal(*dialect.largest)}};
    case WriteFault::Kind::LineTooLong:
      return {
          Message::DialectLineTooLong, range, {dialect.name, std::to_string(dialect.longest_line)}};
    case WriteFault::Kind::KerfImpossible:
      return {Message::KerfNotInDialect, range, {dialect.name}};
    case WriteFault::Kind::LeadLacking:
      return {Message::LeadLacking, range, {}};
    case WriteFault::Kind::LeadTooShort:
      return {Message::LeadTooShort, range, {millimetres(fault.measure), millimetres(fault.limit)}};
    case WriteFault::Kind::OffsetsDiffer:
      return {Message::OffsetsDiffer, range, {}};
    case WriteFault::Kind::BeginsInCorner:
      return {Message::BeginsInCorner, range, {dialect.name}};
    case WriteFault::Kind::PointsInContour:
      return {Message::PointsInContour, range, {}};
    case WriteFault::Kind::ContourTrimmed:
      return {Message::ContourTrimmed, range, {}};
    case WriteFault::Kind::SideChanges:
      return {Message::SideChanges, range, {}};
    case WriteFault::Kind::OffsetsVary:
      return {Message::OffsetsVary, range, {dialect.name}};
    case WriteFault::Kind::EntryMissed:
      return {Message::EntryMissed, range, {}};
    case WriteFault::Kind::EntryUnknown:
      return {Message::EntryUnknown, range, {dialect.name}};
    case WriteFault::Kind::MoveAfterEnd:
      break;
  }
  return {Message::MoveAfterEnd, range, {}};
}

Diagnostic diagnostic_of(const WriteNote& note, const Dialect& dialect, Range range) {
  switch (note.kind) {
    case WriteNote::Kind::FeedDropped:
      return {Message::FeedDropped, range, {dialect.name}};
    case WriteNote::Kind::PowerDropped:
      return {Message::PowerDropped, range, {dialect.name}};
    case WriteNote::Kind::CutsWithTorchOff:
      return {Message::CutsWithTorchOff, range, {note.value}};
    case WriteNote::Kind::FeedDefaulted:
      break;
  }
  return {Message::FeedDefaulted, range, {dialect.name, note.value}};
}

}  // namespace

DiagnosticBag explain(const WriteResult& written, const Dialect& dialect,
                      const Compilation& program) {
  DiagnosticBag bag;
  for (const WriteFault& fault : written.faults) {
    bag.add(diagnostic_of(fault, dialect, range_of(fault.place, program)));
  }
  for (const WriteNote& note : written.report.notes) {
    bag.add(diagnostic_of(note, dialect, range_of(note.place, program)));
  }
  return bag;
}

std::string told(double deviation) {
  constexpr double kStep = 1e-4;
  return fmt::format("{:.4f}", std::ceil(deviation / kStep) * kStep);
}

}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/elements.h"

#include <fmt/format.h>

#include "kernel/check.h"

namespace dgt::language {
namespace {

std::size_t index_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::Line:
      return 0;
    case ElementKind::Circle:
      return 1;
    case ElementKind::Point:
      return 2;
    case ElementKind::Frame:
      break;
  }
  return 3;
}

std::string describe(const ElementEntry& entry) {
  if (entry.point) {
    const ExactPoint& p = entry.point->exact;
    return fmt::format("({}, {})", nearest_double(p.x), nearest_double(p.y));
  }
  if (entry.frame) {
    const FrameDefinition& frame = *entry.frame;
    return fmt::format("origin ({}, {}) angle {}", nearest_double(frame.origin.x),
                       nearest_double(frame.origin.y), to_short_decimal(frame.degrees));
  }
  if (const auto* circle = std::get_if<Circle>(entry.element.get())) {
    return fmt::format("centre ({}, {}) radius {}", nearest_double(circle->centre().x),
                       nearest_double(circle->centre().y), nearest_double(circle->radius()));
  }
  const Line& line = std::get<Line>(*entry.element);
  const UnitVector direction = line.direction();
  return fmt::format("direction ({}, {}) left normal distance {}", nearest_double(direction.x()),
                     nearest_double(direction.y()), nearest_double(line.p()));
}

}  // namespace

ElementEntry& ElementTable::at(ElementKind kind, int number) {
  DGT_CHECK(number >= 0);
  auto& entries = entries_[index_of(kind)];
  const auto index = static_cast<std::size_t>(number);
  if (index >= entries.size()) entries.resize(index + 1);
  return entries[index];
}

const ElementEntry* ElementTable::find(ElementKind kind, int number) const {
  const auto& entries = entries_[index_of(kind)];
  const auto index = static_cast<std::size_t>(number);
  return number >= 0 && index < entries.size() ? &entries[index] : nullptr;
}

const std::vector<ElementEntry>& ElementTable::all(ElementKind kind) const {
  return entries_[index_of(kind)];
}

std::string print_elements(const ElementTable& elements) {
  std::string out;
  for (const ElementKind kind :
       {ElementKind::Line, ElementKind::Circle, ElementKind::Point, ElementKind::Frame}) {
    const auto& entries = elements.all(kind);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (entries[i].state != ElementEntry::State::Defined) continue;
      out += fmt::format("{}{}: {}", static_cast<char>(kind), i, describe(entries[i]));
      if (entries[i].bound > 0) out += fmt::format(" within {:.1e} mm", entries[i].bound);
      if (entries[i].turn > 0) out += fmt::format(" and {:.1e} rad", entries[i].turn);
      out += '\n';
    }
  }
  return out;
}

}  // namespace dgt::language

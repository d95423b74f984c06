// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace dgt {

/// The text of a DXF file from `code value|code value|…`.
inline std::string dxf_text(std::string_view groups) {
  std::string text;
  while (!groups.empty()) {
    const std::string_view group = groups.substr(0, groups.find('|'));
    groups.remove_prefix(std::min(group.size() + 1, groups.size()));
    const std::size_t blank = std::min(group.find(' '), group.size());
    text.append(group.substr(0, blank)).append("\n");
    text.append(group.substr(std::min(blank + 1, group.size()))).append("\n");
  }
  return text;
}

/// A whole file in millimetres with these entities, and with what stands before them.
inline std::string dxf_file(std::string_view entities, std::string_view sections = "") {
  return dxf_text("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC") + dxf_text(sections) +
         dxf_text("0 SECTION|2 ENTITIES") + dxf_text(entities) + dxf_text("0 ENDSEC|0 EOF");
}

}  // namespace dgt

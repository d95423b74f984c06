// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/drawing.h"

#include <algorithm>
#include <utility>

#include "lang/dxf/entity.h"
#include "lang/dxf/groups.h"
#include "lang/text/reading.h"

namespace dgt {
namespace {

/// The remark at the head of a drawing that shows a path (post/dxf.h).
constexpr std::string_view kOwnMark = "dgt plot";
constexpr std::string_view kBinaryMark = "AutoCAD Binary DXF";
constexpr std::string_view kDwgMark = "AC10";

class DrawingReader {
 public:
  DrawingReader(const SourceFile& file, DiagnosticBag& bag)
      : file_(file), bag_(bag), groups_(file, bag) {}

  DxfDrawing run() {
    if (!is_drawing()) return {};
    drawing_.is_of_dgt =
        file_.line_count() > 1 && file_.line_text(1) == "999" && file_.line_text(2) == kOwnMark;
    advance();
    while (at_ && !at_->is(0, "EOF")) {
      if (at_->code == 9) {
        // Old writers closed the header and then went on with it.
        read_header();
        if (at_ && at_->is(0, "ENDSEC")) advance();
        continue;
      }
      if (!at_->is(0, "SECTION")) {
        report(Message::DxfNoSection, at_->value, {std::string(at_->text())});
        return std::move(drawing_);
      }
      advance();
      read_section();
    }
    if (!at_ && !groups_.is_broken() && !bag_.has_errors()) {
      report(Message::DxfEndLacking, end_of_file());
    }
    return std::move(drawing_);
  }

 private:
  // --- the file

  bool is_drawing() {
    if (file_.is_utf16()) {
      report_reading(file_, bag_);
      return false;
    }
    const std::string_view text = file_.text();
    const Range begin{&file_, 0, 0};
    if (text.starts_with(kBinaryMark)) {
      report(Message::DxfBinary, begin);
    } else if (text.starts_with(kDwgMark)) {
      report(Message::DxfIsDwg, begin);
    } else if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
      report(Message::DxfEmpty, begin);
    } else {
      return true;
    }
    return false;
  }

  void report(Message message, const Range& place, std::vector<std::string> arguments = {}) {
    bag_.add({message, place, std::move(arguments)});
  }
  [[nodiscard]] Range end_of_file() const {
    const auto end = static_cast<std::uint32_t>(file_.text().size());
    return {&file_, end, end};
  }

  void advance() { at_ = groups_.next(); }

  // --- sections

  void read_section() {
    const std::string name = at_ && at_->code == 2 ? std::string(at_->text()) : "";
    if (at_ && at_->code == 2) advance();
    if (name == "HEADER") read_header();
    if (name == "TABLES") read_tables();
    if (name == "BLOCKS") read_blocks();
    if (name == "ENTITIES") read_entities(drawing_.entities, "ENDSEC");
    while (at_ && !at_->is(0, "ENDSEC")) {
      if (at_->is(0, "SECTION") || at_->is(0, "EOF")) return truncated();
      advance();
    }
    if (!at_) return truncated();
    advance();
  }

  /// The file ends inside of something: half a drawing would be cut.
  void truncated() {
    if (groups_.is_broken() || bag_.has_errors()) return;
    report(Message::DxfTruncated, at_ ? at_->value : end_of_file());
  }

  void read_header() {
    bool is_units = false;
    for (; at_ && at_->code != 0; advance()) {
      if (at_->code == 9) {
        is_units = at_->text() == "$INSUNITS";
      } else if (is_units && at_->code == 70) {
        drawing_.units = groups_.whole(*at_);
        drawing_.units_place = at_->value;
      }
    }
  }

  /// The pairs behind the name at which the reader stands.
  DxfRecord read_record() {
    DxfRecord record;
    record.name = at_->value;
    for (advance(); at_ && at_->code != 0; advance()) record.groups.push_back(*at_);
    return record;
  }

  void read_tables() {
    while (at_ && !at_->is(0, "ENDSEC") && !at_->is(0, "EOF")) {
      const DxfRecord record = read_or_skip();
      const DxfGroup* const name = record.find(2);
      if (name == nullptr || record.name.text() != "LAYER") continue;
      DxfLayer layer;
      if (const DxfGroup* const flags = record.find(70))
        layer.frozen = (groups_.whole(*flags) & 1) != 0;
      if (const DxfGroup* const colour = record.find(62)) layer.off = groups_.whole(*colour) < 0;
      drawing_.layers[dxf_key(name->text())] = layer;
    }
  }
  DxfRecord read_or_skip() {
    if (at_->code == 0) return read_record();
    advance();
    return {};
  }

  void read_blocks() {
    while (at_ && !at_->is(0, "ENDSEC") && !at_->is(0, "EOF")) {
      if (!at_->is(0, "BLOCK")) {
        advance();
        continue;
      }
      read_block(read_record());
    }
  }

  void read_block(const DxfRecord& head) {
    DxfBlock block;
    const DxfGroup* const name = head.find(2);
    const DxfGroup* const x = head.find(10);
    const DxfGroup* const y = head.find(20);
    if (x != nullptr) block.base.x = groups_.number(*x);
    if (y != nullptr) block.base.y = groups_.number(*y);
    read_entities(block.entities, "ENDBLK");
    if (name == nullptr) return report(Message::DxfLacking, head.name, {"BLOCK", "2"});
    drawing_.blocks[dxf_key(name->text())] = std::move(block);
  }

  void read_entities(std::vector<DxfEntity>& entities, std::string_view end) {
    while (at_ && !at_->is(0, end)) {
      if (at_->is(0, "ENDSEC") || at_->is(0, "EOF") || at_->is(0, "SECTION")) return truncated();
      if (at_->code != 0) {
        advance();
        continue;
      }
      DxfRecord record = read_record();
      if (record.name.text() == "POLYLINE") read_vertices(record);
      if (record.name.text() != "SEQEND" && record.name.text() != "ATTRIB")
        entities.push_back(dxf_entity(record, groups_, bag_));
    }
  }

  void read_vertices(DxfRecord& polyline) {
    while (at_ && at_->is(0, "VERTEX")) polyline.vertices.push_back(read_record());
    if (!at_ || !at_->is(0, "SEQEND")) {
      report(Message::DxfOpenSequence, polyline.name);
      return;
    }
    (void)read_record();
  }

  const SourceFile& file_;
  DiagnosticBag& bag_;
  DxfGroups groups_;
  std::optional<DxfGroup> at_;
  DxfDrawing drawing_;
};

}  // namespace

std::string dxf_key(std::string_view name) {
  std::string key(name);
  std::ranges::transform(key, key.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return key;
}

DxfDrawing read_dxf_drawing(const SourceFile& file, DiagnosticBag& bag) {
  return DrawingReader(file, bag).run();
}

}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/gcode.h"

#include <fmt/format.h>

#include <optional>

#include "post/program_text.h"

namespace dgt {
namespace {

class Writer {
 public:
  Writer(const Toolpath& path, const Dialect& dialect, ProgramText& text)
      : path_(path),
        dialect_(dialect),
        spelling_(dialect.spelling),
        text_(text),
        unit_(decimal_unit(dialect.unit)),
        absolute_(dialect.positions == Positions::Absolute),
        feeds_(dialect) {}

  void write(const Block& block) {
    line_.clear();
    append_block(block);
    text_.add({line_.data(), line_.size()}, block.move);
  }

 private:
  void append_block(const Block& block) {
    switch (block.kind) {
      case BlockKind::Rapid:
        append_motion(spelling_.rapid);
        return append_end(block);
      case BlockKind::Line:
        append_motion(spelling_.line);
        append_end(block);
        return append_feed(block);
      case BlockKind::Arc:
        append_motion(block.path.ccw ? spelling_.counter_clockwise : spelling_.clockwise);
        append_end(block);
        append_bend(block);
        return append_feed(block);
      case BlockKind::Dwell:
        motion_.clear();  // G04 is no motion, but there are controls that forget theirs
        append(dialect_.dwell_word);
        return append(dwell_number(path_.moves[block.move], dialect_));
      case BlockKind::Words:
        motion_.clear();
        return append(block.words);
    }
  }

  void append(std::string_view text) { line_.append(text.data(), text.data() + text.size()); }

  void append_motion(const std::string& motion) {
    if (!spelling_.repeats_motion && motion == motion_) return;
    motion_ = motion;
    append(motion);
  }

  void append_end(const Block& block) {
    const GridPoint& to = block.path.to;
    const GridPoint& from = block.path.from;
    append_position(spelling_.x, to.x, from.x, block);
    append_position(spelling_.y, to.y, from.y, block);
    if (!block.has_height) return;
    append_word(spelling_.z, absolute_ ? block.height : block.height - height_, block);
    height_ = block.height;
  }

  void append_position(std::string_view word, std::int64_t to, std::int64_t from,
                       const Block& block) {
    if (!absolute_) {
      if (to != from || spelling_.zero_words) append_word(word, to - from, block);
    } else if (to != from || spelling_.repeats_position || block.kind == BlockKind::Rapid) {
      append_word(word, to, block);
    }
  }

  void append_bend(const Block& block) {
    const WrittenArc& arc = block.path;
    if (dialect_.arc_form == ArcForm::Radius)
      return append_word(spelling_.r, arc.major ? -arc.radius : arc.radius, block);
    const GridPoint origin = dialect_.centre_is_absolute ? GridPoint{} : arc.from;
    append_centre(spelling_.i, arc.centre.x - origin.x, block);
    append_centre(spelling_.j, arc.centre.y - origin.y, block);
  }

  void append_centre(std::string_view word, std::int64_t units, const Block& block) {
    if (units != 0 || spelling_.zero_words || dialect_.centre_is_absolute)
      append_word(word, units, block);
  }

  void append_word(std::string_view word, std::int64_t units, const Block& block) {
    text_.check_size(units, block.move);
    if (line_.size() > 0) append(spelling_.separator);
    append(word);
    append_millimetres(line_, units, unit_, spelling_);
  }

  void append_feed(const Block& block) {
    const std::string feed = feeds_.next(path_.moves[block.move]);
    if (feed.empty()) return;
    if (line_.size() > 0) append(spelling_.separator);
    append(dialect_.feed_word);
    append(feed);
  }

  const Toolpath& path_;
  const Dialect& dialect_;
  const Spelling& spelling_;
  ProgramText& text_;
  const DecimalUnit unit_;
  const bool absolute_;
  FeedWords feeds_;
  std::int64_t height_ = 0;
  std::string motion_;
  fmt::memory_buffer line_;
};

}  // namespace

std::string gcode_text(const Plan& plan, const Toolpath& path, const Dialect& dialect,
                       std::vector<WriteFault>& faults) {
  ProgramText text(plan, dialect, faults);
  Writer writer(path, dialect, text);
  for (const Block& block : plan.blocks) writer.write(block);
  return text.finish();
}

}  // namespace dgt

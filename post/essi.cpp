// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/essi.h"

#include <fmt/format.h>

#include <cstdlib>

#include "post/program_text.h"

namespace dgt {
namespace {

class Writer {
 public:
  Writer(const Toolpath& path, const Dialect& dialect, ProgramText& text)
      : path_(path), dialect_(dialect), text_(text), feeds_(dialect) {}

  void write(const Block& block) {
    line_.clear();
    switch (block.kind) {
      case BlockKind::Words:
        return text_.add(block.words, block.move);
      case BlockKind::Dwell:
        return write_code(dialect_.dwell_word, dwell_number(path_.moves[block.move], dialect_),
                          block);
      default:
        break;
    }
    if (block.kind != BlockKind::Rapid)
      write_code(dialect_.feed_word, feeds_.next(path_.moves[block.move]), block);
    append_travel(block);
    text_.add({line_.data(), line_.size()}, block.move);
  }

 private:
  /// A code with its value, which controls do not take as zero.
  void write_code(const std::string& word, const std::string& value, const Block& block) {
    if (value.empty() || value == "0") return;
    text_.add(word + value, block.move);
  }

  void append_travel(const Block& block) {
    const WrittenArc& path = block.path;
    append_signed(path.to.x - path.from.x, block);
    append_signed(path.to.y - path.from.y, block);
    if (block.kind != BlockKind::Arc) return;
    if (dialect_.arc_form == ArcForm::Radius) {
      append_signed(path.radius, block);
      line_.push_back(path.major ? '+' : '-');
    } else {
      append_signed(path.centre.x - path.from.x, block);
      append_signed(path.centre.y - path.from.y, block);
    }
    line_.push_back(path.ccw == dialect_.plus_is_ccw ? '+' : '-');
  }

  void append_signed(std::int64_t value, const Block& block) {
    text_.check_size(value, block.move);
    line_.push_back(value < 0 ? '-' : '+');
    if (value == 0) return;
    const fmt::format_int digits(std::llabs(value));
    line_.append(digits.data(), digits.data() + digits.size());
  }

  const Toolpath& path_;
  const Dialect& dialect_;
  ProgramText& text_;
  FeedWords feeds_;
  fmt::memory_buffer line_;
};

}  // namespace

std::string essi_text(const Plan& plan, const Toolpath& path, const Dialect& dialect,
                      std::vector<WriteFault>& faults) {
  ProgramText text(plan, dialect, faults);
  Writer writer(path, dialect, text);
  for (const Block& block : plan.blocks) writer.write(block);
  return text.finish();
}

}  // namespace dgt

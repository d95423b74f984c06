// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contours that the control offsets, read back with the kerf applied: they are the equidistant.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/driver/pipeline.h"
#include "lang/text/render.h"
#include "post/write.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

using support::TemporaryFolder;

struct Case {
  const char* dialect;
  const char* extension;
};

Toolpath path_of(const std::string& file, const Rational& kerf, const Rational& essi_unit) {
  SourceSettings settings;
  settings.essi.nc.kerf_width = kerf;
  settings.gcode.nc.kerf_width = kerf;
  settings.essi.unit = essi_unit;
  if (file.ends_with(".iso")) settings.from = InputLanguage::EssiIso;
  const auto made = compile_file(file, settings);
  EXPECT_TRUE(made->result.path) << render(made->bag);
  return made->result.path ? *made->result.path : Toolpath{};
}

/// The ends of what is cut of the contours with an offset, one after the other.
std::vector<const Move*> parts_of(const Toolpath& path) {
  std::vector<const Move*> parts;
  for (const Contour& contour : path.contours) {
    if (contour.side == Side::None) continue;
    for (std::size_t i = contour.first; i < contour.last; ++i)
      if (path.moves[i].cuts() && is_part(path.moves[i])) parts.push_back(&path.moves[i]);
  }
  return parts;
}

class ControlOffset : public ::testing::TestWithParam<Case> {};

TEST_P(ControlOffset, IsTheEquidistantWhenReadBack) {
  const std::string plate =
      "L1=Y0\nL2=X40\nL3=Y30\nL4=X0\nC1=X40 Y15 R-6\nP1=X20 Y-5\nG54 X20 Y-5\nF100\n"
      "K1 W0.25 P1 L1 L-2 C1 L-2 L-3 L4 L1 P1\n";
  const TemporaryFolder folder;
  for (const std::string& source :
       {support::read_text(support::corpus("rows/contour_w.bgt")), plate}) {
    const Toolpath exact = path_of(folder.write("part.bgt", source), 0, 1);
    Dialect dialect = *find_dialect(GetParam().dialect);
    dialect.unit = Rational(1, 1000);
    dialect.radius_mismatch = Rational(1, 1000);
    dialect.compensation = Compensation::Control;
    const WriteResult written = write(exact, dialect);
    ASSERT_TRUE(written.faults.empty());
    const Rational width = 2 * exact.contours.front().offset;
    const std::string file = folder.write(std::string("part") + GetParam().extension, written.text);
    const Toolpath read = path_of(file, width, dialect.unit);
    const auto wanted = parts_of(exact);
    const auto found = parts_of(read);
    ASSERT_GT(wanted.size(), 5u);
    // Increments do not say where they begin.
    const bool is_absolute = dialect.positions == Positions::Absolute;
    const double begin_x = is_absolute ? 0 : nearest_double(exact.start.x);
    const double begin_y = is_absolute ? 0 : nearest_double(exact.start.y);
    std::size_t next = 0;
    for (const Move* const move : wanted) {
      // Pieces of one arc come one after the other.
      const auto is_there = [&](const Move* m) {
        return std::hypot(m->to.x() + begin_x - move->to.x(), m->to.y() + begin_y - move->to.y()) <
               0.0025;
      };
      while (next < found.size() && !is_there(found[next])) ++next;
      ASSERT_LT(next, found.size()) << move->to.x() << " " << move->to.y() << "\n" << written.text;
      EXPECT_EQ(found[next]->kind, move->kind);
    }
    EXPECT_LE(found.size(), wanted.size() + 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Control, ControlOffset,
                         ::testing::Values(Case{"linuxcnc", ".ngc"}, Case{"plasmatic", ".cnc"},
                                           Case{"fanuc-wire", ".tap"}, Case{"essi", ".ess"},
                                           Case{"essi-iso", ".iso"}),
                         [](const auto& i) { return std::to_string(i.index); });

}  // namespace
}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs written in DGT: what they say when they are compiled, and what a person reads.
#include "apps/driver/dgt_source.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using support::run_dgt;
using support::TemporaryFolder;
using ::testing::HasSubstr;

Toolpath path_of(const std::string& name, const std::string& text) {
  Compilation made = compile_bytes(name, text, {});
  EXPECT_TRUE(made.result.path.has_value()) << name << '\n' << text;
  return made.result.path ? *std::move(made.result.path) : Toolpath();
}

double apart(const Point& a, const Point& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

/// Moves against moves, in doubles: nothing of what judges when they are written.
void expect_same_moves(const Toolpath& path, const Toolpath& again, const std::string& where) {
  ASSERT_EQ(path.moves.size(), again.moves.size()) << where;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& a = path.moves[i];
    const Move& b = again.moves[i];
    ASSERT_EQ(a.kind, b.kind) << where << ", move " << i;
    EXPECT_LE(apart(a.from, b.from), kDgtDeviation) << where << ", move " << i;
    EXPECT_LE(apart(a.to, b.to), kDgtDeviation) << where << ", move " << i;
    if (a.kind != MoveKind::Arc) continue;
    EXPECT_EQ(a.full_circle, b.full_circle) << where << ", move " << i;
    EXPECT_EQ(a.circle().counter_clockwise(), b.circle().counter_clockwise()) << where;
    // The middle of the arc, where a wrong radius shows most.
    const auto middle = [](const Move& arc) {
      const double sagitta = std::fabs(nearest_double(arc.circle().radius())) *
                             (1 - std::cos(sweep_degrees(arc) * std::acos(-1.0) / 360));
      return sagitta;
    };
    EXPECT_NEAR(middle(a), middle(b), 2 * kDgtDeviation) << where << ", move " << i;
  }
}

void expect_written_back(const std::string& name, const std::string& text) {
  const Toolpath path = path_of(name, text);
  const DgtSource source = write_dgt(path, name);
  ASSERT_TRUE(source.written.faults.empty()) << name << '\n' << text;
  EXPECT_LE(source.written.report.deviation, kDgtDeviation);
  expect_same_moves(path, path_of("again.bgt", source.written.text),
                    name + '\n' + source.written.text);
}

// --- the corpus ---------------------------------------------------------------------------------

TEST(DgtSource, EveryProgramOfTheCorpusSaysTheSameWhenItIsWrittenAgain) {
  std::size_t count = 0;
  std::size_t by_points = 0;
  std::size_t without_width = 0;
  for (const auto& entry : fs::recursive_directory_iterator(support::corpus(""))) {
    const fs::path& file = entry.path();
    const bool is_golden = file.string().find("/golden/") != std::string::npos;
    if (is_golden || !language_of(file) || file.parent_path().filename() == "mac") continue;
    if (file.filename() == "contour_z.bgt") continue;  // a helix
    const auto made = compile_file(file, {});
    if (!made || !made->result.path) continue;
    const DgtSource source = write_dgt(*made->result.path, file.filename());
    ASSERT_TRUE(source.written.faults.empty()) << file;
    expect_same_moves(*made->result.path, path_of("again.bgt", source.written.text), file);
    ++count;
    by_points += source.by_points;
    without_width += source.without_width;
  }
  EXPECT_GT(count, 120U);
  EXPECT_LT(by_points, 8U);
  EXPECT_LT(without_width, 24U);
}

TEST(DgtSource, IsLaidOutAsFormatDoes) {
  const TemporaryFolder folder;
  for (const char* program : {"1P.bgt", "4P.bgt", "essi/star.ess", "dxf/plate.dxf"}) {
    const std::string name = folder.name("a.bgt");
    ASSERT_EQ(run_dgt({"convert", support::corpus(program), "--to", "dgt", "-o", name}).exit_code,
              0);
    EXPECT_EQ(run_dgt({"format", name}).out, support::read_text(name)) << program;
  }
}

// --- what a person reads ------------------------------------------------------------------------

TEST(DgtSource, RoundedCornersAreFilletsAndHolesCircles) {
  const std::string corner = "0.41421356237309503";
  const DgtSource source =
      write_dgt(path_of("t.poly", "50 0 0\n90 0 " + corner + "\n100 10 0\n100 50 " + corner +
                                      "\n90 60 0\n10 60 " + corner + "\n0 50 0\n0 10 " + corner +
                                      "\n10 0 0\n\n28 30 1\n12 30 1\n"),
                "plate");
  EXPECT_EQ(source.written.text,
            "' plate\n"
            "G54 X50 Y0\n"
            "L1=Y0\n"
            "L2=X100\n"
            "L3=Y60\n"
            "L4=X0\n"
            "P1=X50 Y0\n"
            "K1 P1 L1 R10 L-2 R10 L-3 R10 L4 R10 L1 P1\n"
            "G0 X28 Y30\n"
            "C1=X20 Y30 R8\n"
            "P2=X28 Y30\n"
            "P3=X12 Y30\n"
            "K2 P2 C1 P3 C1 P2\n");
}

TEST(DgtSource, TheWidthOfAContourIsKept) {
  const auto outcome = run_dgt({"convert", support::corpus("1P.bgt"), "--to", "dgt"});
  EXPECT_THAT(outcome.out, HasSubstr("\nK1 W0.2 L6 C-1 L-1 C-2 L2 C-3 L3"));
  EXPECT_THAT(outcome.out, HasSubstr("\nC2=X0 Y0 R7\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\n'@ offset-side right\n"));
  EXPECT_THAT(outcome.err, HasSubstr("dgt: 1 contours, at most "));
}

TEST(DgtSource, ALineBetweenTwoCirclesIsTheirTangent) {
  const DgtSource slot = write_dgt(path_of("t.poly", "4 -3 0\n34 37 1\n26 43 0\n-4 3 1\n"), "slot");
  EXPECT_EQ(slot.written.text,
            "' slot\n"
            "G54 X4 Y-3\n"
            "C1=X30 Y40 R5\n"
            "C2=X0 Y0 R5\n"
            "L1=C2 C1\n"
            "L2=C1 C2\n"
            "K1 C2 L1 C1 L2 C2 L1\n");
}

TEST(DgtSource, TorchAndCodesStandWhereTheyAct) {
  const auto outcome = run_dgt({"convert", support::corpus("essi/loop.ess"), "--to", "dgt"});
  EXPECT_THAT(outcome.out, HasSubstr("\nM7\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\nM8\nG0 X130 Y70\nM7\n"));
}

// --- bad days -----------------------------------------------------------------------------------

TEST(DgtSource, AHelixAndAForeignCodeAreRefusedWithTheirPlaces) {
  const TemporaryFolder folder;
  const std::string out = folder.name("a.bgt");
  const auto helix =
      run_dgt({"convert", support::corpus("rows/contour_z.bgt"), "--to", "dgt", "-o", out});
  EXPECT_EQ(helix.exit_code, 1);
  EXPECT_THAT(helix.err, HasSubstr("contour_z.bgt:6:11: error: the dialect dgt has no heights"));
  const auto code =
      run_dgt({"convert", folder.write("b.ess", "53\n+100+\n77\n"), "--to", "dgt", "-o", out});
  EXPECT_EQ(code.exit_code, 1);
  EXPECT_THAT(code.err, HasSubstr("b.ess:3:1: error:"));
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"b.ess"});
}

// --- contours of every kind ---------------------------------------------------------------------

/// A closed polyline about the origin whose corners are rounded, cut or bulged at random.
std::string random_contour(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  const int corners = 3 + static_cast<int>(seed % 6);
  std::vector<std::pair<double, double>> at;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::acos(-1.0) * (i + between(0, 0.6)) / corners;
    const double radius = between(20, 60);
    at.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  std::string text;
  const auto vertex = [&](double x, double y, double bulge) {
    text += fmt::format("{:.{}f} {:.{}f} {:.12f}\n", x, seed % 3 == 0 ? 3 : 12, y,
                        seed % 3 == 0 ? 3 : 12, bulge);
  };
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto& [x, y] = at[i];
    const auto& before = at[(i + at.size() - 1) % at.size()];
    const auto& behind = at[(i + 1) % at.size()];
    const double back = std::hypot(before.first - x, before.second - y);
    const double ahead = std::hypot(behind.first - x, behind.second - y);
    const double reach = between(0.05, 0.4) * std::min(back, ahead);
    const double ux = (before.first - x) / back;
    const double uy = (before.second - y) / back;
    const double vx = (behind.first - x) / ahead;
    const double vy = (behind.second - y) / ahead;
    const double turn = std::acos(-1.0) - std::acos(ux * vx + uy * vy);
    const double sense = ux * vy - uy * vx < 0 ? 1 : -1;
    switch (random() % 4) {
      case 0:
        vertex(x, y, 0);
        break;
      case 1:
        vertex(x, y, between(-1.2, 1.2));
        break;
      default:
        vertex(x + reach * ux, y + reach * uy, sense * std::tan(turn / 4));
        vertex(x + reach * vx, y + reach * vy, 0);
    }
  }
  return text;
}

TEST(DgtSource, ContoursOfEveryKindSayTheSameWhenTheyAreWritten) {
  for (unsigned seed = 1; seed <= 150; ++seed)
    expect_written_back("contour.poly", random_contour(seed));
}

TEST(DgtSource, OpenContoursDoSoToo) {
  for (unsigned seed = 1; seed <= 50; ++seed)
    expect_written_back("contour.poly", "open\n" + random_contour(seed));
}

}  // namespace
}  // namespace dgt

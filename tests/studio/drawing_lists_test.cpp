// SPDX-License-Identifier: GPL-3.0-or-later
// Control points and the internal form.
#include <gmock/gmock.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include "apps/driver/points.h"
#include "apps/studio/drawing/internal_form.h"
#include "apps/studio/drawing/points_panel.h"
#include "tests/studio/drawing_parts.h"
#include "tests/studio/qt_values.h"

namespace dgt::studio {
namespace {

template <class Panel>
bool show(Panel& panel, const PartPtr& part) {
  panel.resize(700, 500);
  panel.show();
  panel.show_part(part);
  return QTest::qWaitFor([&] { return panel.is_settled(); });
}

QString cell(const PointsPanel& panel, int row, int column) {
  return const_cast<PointsPanel&>(panel).table().model()->index(row, column).data().toString();
}

TEST(Points, AreThoseOfTheCommand) {
  PointsPanel panel;
  ASSERT_TRUE(show(panel, corpus_part("4P.bgt")));
  const auto command = support::run_dgt({"points", support::corpus("4P.bgt")});
  EXPECT_EQ(panel.text().toStdString(), command.out);
  QTest::keyClick(&panel.table(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QGuiApplication::clipboard()->text().toStdString(), command.out);
}

TEST(Points, TheTableShowsNumberPlaceKindCentreAndRadius) {
  PointsPanel panel;
  ASSERT_TRUE(show(panel, part_of("P1=X0Y0\nC1=P1R12.5\nP2=X12.5Y0\nG54P2\nK1 P2 C1 P2\n")));
  ASSERT_EQ(panel.table().model()->rowCount(), 2);
  EXPECT_EQ(cell(panel, 0, PointsModel::Number), QStringLiteral("1"));
  EXPECT_EQ(cell(panel, 0, PointsModel::Kind), QStringLiteral("start"));
  EXPECT_EQ(cell(panel, 1, PointsModel::X), QStringLiteral("12.500000"));
  EXPECT_EQ(cell(panel, 1, PointsModel::Kind), QStringLiteral("arc"));
  EXPECT_EQ(cell(panel, 1, PointsModel::CentreX), QStringLiteral("0.000000"));
  EXPECT_EQ(cell(panel, 1, PointsModel::Radius), QStringLiteral("12.500000"));
}

TEST(Points, SeveralChosenOnesAreCopiedAlone) {
  PointsPanel panel;
  const PartPtr part = corpus_part("1P.bgt");
  ASSERT_TRUE(show(panel, part));
  panel.choose_point(3);
  QTest::keyClick(&panel.table(), Qt::Key_Down, Qt::ShiftModifier);
  const auto points = control_points(*part->path());
  const std::span chosen = std::span(points).subspan(2, 2);
  EXPECT_EQ(panel.text().toStdString(), list_points(chosen, 3));
}

TEST(Points, AChosenRowTellsItsNumberAndEnterItsPlace) {
  PointsPanel panel;
  ASSERT_TRUE(show(panel, part_of(kRectangle)));
  QSignalSpy number(&panel, &PointsPanel::point_chosen);
  QSignalSpy place(&panel, &PointsPanel::place_chosen);
  panel.choose_point(3);
  EXPECT_EQ(number.last()[0].toInt(), 3);
  EXPECT_EQ(place.count(), 0);
  QTest::keyClick(&panel.table(), Qt::Key_Return);
  ASSERT_EQ(place.count(), 1);
  EXPECT_EQ(place[0], (QList<QVariant>{0, 7, 10}));
}

TEST(Points, MarksOfTheDrawingHaveTheNumbersOfTheTable) {
  const PartPtr part = corpus_part("3P.bgt");
  const ScenePtr scene = make_scene(part, {}).value();
  const auto points = control_points(*part->path());
  ASSERT_EQ(points.size(), scene->path.steps() + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(scene->path.place({i, 0}), (DrawnPlace{points[i].x, points[i].y})) << i + 1;
  }
}

TEST(InternalForm, IsThatOfTheCommand) {
  InternalForm form;
  ASSERT_TRUE(show(form, corpus_part("3P.bgt")));
  const auto command = support::run_dgt({"dump", support::corpus("3P.bgt")});
  EXPECT_EQ(form.text().toStdString(), command.out);
  QTest::keyClick(&form.lines(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QGuiApplication::clipboard()->text().toStdString(), command.out);
}

TEST(InternalForm, IsSearchedForwardsAndBackwards) {
  InternalForm form;
  ASSERT_TRUE(show(form, part_of(kRectangle)));
  QTest::keyClick(&form.lines(), Qt::Key_F, Qt::ControlModifier);
  auto* wanted = form.findChild<QLineEdit*>();
  ASSERT_TRUE(wanted->hasFocus());
  QTest::keyClicks(wanted, QStringLiteral("y20.0"));
  QTest::keyClick(wanted, Qt::Key_Return);
  const auto row = [&] { return form.lines().currentIndex().row(); };
  EXPECT_EQ(row(), 3) << "start, contour, first side, second";
  QTest::keyClick(wanted, Qt::Key_Return);
  EXPECT_EQ(row(), 4);
  QTest::keyClick(wanted, Qt::Key_Return);
  EXPECT_EQ(row(), 3) << "from the end it goes on at the beginning";
  form.find_previous();
  EXPECT_EQ(row(), 4);
}

TEST(InternalForm, LinesAndMovesBelongTogether) {
  InternalForm form;
  ASSERT_TRUE(show(form, part_of(kRectangle)));
  QSignalSpy place(&form, &InternalForm::place_chosen);
  form.lines().setCurrentIndex(form.lines().model()->index(4, 0));
  QTest::keyClick(&form.lines(), Qt::Key_Return);
  ASSERT_EQ(place.count(), 1);
  EXPECT_EQ(place[0], (QList<QVariant>{0, 7, 13}));
  const auto is_lit = [&](int row) {
    return form.lines().model()->index(row, 0).data(Qt::BackgroundRole).isValid();
  };
  form.light_line(0, 7);
  EXPECT_TRUE(is_lit(2));
  EXPECT_FALSE(is_lit(1)) << "the head of the contour is no move";
  form.light_line(0, 6);
  EXPECT_FALSE(is_lit(2));
}

TEST(InternalForm, APartWithErrorsLeavesTheLastGoodText) {
  InternalForm form;
  ASSERT_TRUE(show(form, part_of(kRectangle)));
  const QString good = form.text();
  form.show_part(part_of("L1=\n"));
  EXPECT_EQ(form.text(), good);
}

}  // namespace
}  // namespace dgt::studio

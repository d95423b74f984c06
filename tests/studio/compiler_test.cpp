// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/compiler.h"

#include <gmock/gmock.h>

#include <QSignalSpy>

#include "tests/studio/qt_values.h"

namespace dgt::studio {
namespace {

Compiler::Request request(std::uint64_t revision, std::string bytes) {
  return {.revision = revision, .name = "part.bgt", .bytes = std::move(bytes), .settings = {}};
}

PartPtr last_made(QSignalSpy& spy) { return spy.last().at(0).value<PartPtr>(); }

TEST(Compiler, MakesAPathInTheBackground) {
  Compiler compiler;
  QSignalSpy made(&compiler, &Compiler::made);
  compiler.ask(request(7, "L1=X0\nL2=Y0\nP1=L1 L2\nG54P1\n"));
  ASSERT_TRUE(made.wait());
  EXPECT_EQ(last_made(made)->revision, 7U);
  ASSERT_NE(last_made(made)->path(), nullptr);
}

TEST(Compiler, TellsFaultsInsteadOfAPath) {
  Compiler compiler;
  QSignalSpy made(&compiler, &Compiler::made);
  compiler.ask(request(1, "L1=X\n"));
  ASSERT_TRUE(made.wait());
  EXPECT_EQ(last_made(made)->path(), nullptr);
  EXPECT_TRUE(last_made(made)->compilation.bag.has_errors());
}

TEST(Compiler, TheNewestRequestIsAnsweredAndNotAllBeforeIt) {
  Compiler compiler;
  QSignalSpy made(&compiler, &Compiler::made);
  std::string loop = "N1=0\nFOR 200000\nN1=N1+1\nNEXT\n";
  for (std::uint64_t revision = 1; revision <= 20; ++revision) {
    compiler.ask(request(revision, loop));
  }
  while (made.isEmpty() || last_made(made)->revision != 20) ASSERT_TRUE(made.wait(30000));
  EXPECT_LE(made.count(), 3);
}

}  // namespace
}  // namespace dgt::studio

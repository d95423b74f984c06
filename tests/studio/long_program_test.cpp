// SPDX-License-Identifier: GPL-3.0-or-later
// Ten megabytes of source: the window goes on answering while they are compiled and kept.
#include <gmock/gmock.h>

#include <QElapsedTimer>

#include "tests/studio/studio_window.h"

namespace dgt::studio {
namespace {

/// A person takes a window for frozen that does not answer for so long. Measured are 0.2 s; the
/// rest is for machines that do much else.
constexpr qint64 kFrozen = 2000;  // ms

class LongProgram : public StudioWindow {
 protected:
  /// The longest time in which the window did nothing else, until `done`.
  template <typename Done>
  static qint64 longest_pause(Done done) {
    QElapsedTimer waited;
    waited.start();
    QElapsedTimer pause;
    qint64 longest = 0;
    pause.start();
    while (!done() && waited.elapsed() < 100'000) {
      QTest::qWait(1);
      longest = std::max(longest, pause.restart());
    }
    EXPECT_TRUE(done());
    return longest;
  }
  [[nodiscard]] bool is_compiled() const { return window->compiler().current() != nullptr; }
};

TEST_F(LongProgram, IsTypedIntoCompiledAndKeptWithoutAPause) {
  std::string program;
  for (int i = 0; program.size() < 10'000'000; ++i) {
    program += "P" + std::to_string(i % 9999) + "=X" + std::to_string(i % 500) + ".5 Y7 ' hole\n";
  }
  folder.write("long.bgt", program);
  ASSERT_TRUE(window->open_file(file("long.bgt")));
  EXPECT_LT(longest_pause([&] { return is_compiled(); }), kFrozen);
  QElapsedTimer typing;
  typing.start();
  type(QStringLiteral("L1=X5\n"));
  window->grab();
  EXPECT_LT(typing.elapsed(), kFrozen);
  const auto* const recovery = window->documents().findChild<Recovery*>();
  ASSERT_NE(recovery, nullptr);
  EXPECT_LT(longest_pause([&] { return is_compiled() && recovery->is_kept(); }), kFrozen);
}

}  // namespace
}  // namespace dgt::studio

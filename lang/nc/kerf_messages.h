// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/contour.h"
#include "lang/nc/program.h"

namespace dgt {

/// Tells what is wrong with runs of cuts, with the blocks they stand in.
class KerfMessages {
 public:
  KerfMessages(const SourceFile& file, const NcProgram& program, DiagnosticBag& bag)
      : file_(file), program_(program), bag_(bag) {}

  /// `first`: of the run, an index into the program's moves.
  void report(const BuiltContour& built, std::size_t first);
  /// About one block.
  void report(Message message, std::size_t move, std::vector<std::string> arguments = {});

  [[nodiscard]] Range block_of(std::size_t move) const;
  [[nodiscard]] std::string text_of(std::size_t move) const;

 private:
  void report(const ContourFault& fault, std::size_t first);
  void report(const ContourNotice& notice, std::size_t first);
  [[nodiscard]] Diagnostic told(const ContourFault& fault, std::size_t first) const;
  /// Of two blocks, a measure and where the tool is.
  [[nodiscard]] Diagnostic at_place(Message message, std::size_t move, std::size_t other,
                                    double measure, double x, double y) const;
  void add(Diagnostic diagnostic, std::size_t move);

  const SourceFile& file_;
  const NcProgram& program_;
  DiagnosticBag& bag_;
};

}  // namespace dgt

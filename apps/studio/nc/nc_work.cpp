// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/nc/nc_work.h"

#include "apps/driver/control_proof.h"
#include "apps/driver/nc_files.h"
#include "apps/driver/write_messages.h"

namespace dgt::studio {

NcProgramTextPtr write_nc(const NcWish& wish) {
  auto made = std::make_shared<NcProgramText>();
  made->wish = wish;
  made->machine = settle(wish.machine);
  if (!made->machine.settings) return made;
  Dialect& dialect = made->machine.settings->dialect;
  if (wish.compensation) dialect.compensation = *wish.compensation;
  made->written = write(*wish.part->path(), dialect);
  made->said = explain(made->written, dialect, wish.part->compilation);
  return made;
}

PartPtr read_nc(const NcProgramText& base, const std::string& name, const std::string& bytes) {
  auto read = std::make_shared<Part>();
  read->revision = base.wish.part->revision;
  read->name = name;
  read->settings = base.settings();
  read->settings.source = as_its_control(base.settings());
  read->settings.source.from = language_of(base.settings().dialect);
  read->settings.source.encoding = Encoding::Utf8;
  read->compilation = compile_bytes(name, bytes, read->settings.source);
  return read;
}

Certificate prove_nc(const Part& read, const Part& exact, const Settings& settings) {
  return prove({read.name, read.compilation, read.settings.source},
               {exact.name, exact.compilation, exact.settings.source}, settings.dialect,
               limits_of(settings.dialect));
}

}  // namespace dgt::studio

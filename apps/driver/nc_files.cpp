// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/nc_files.h"

namespace dgt {

const char* extension_of(const Dialect& dialect) {
  if (dialect.form == Form::Essi) return ".ess";
  if (dialect.form == Form::ThreeB) return ".3b";
  return dialect.name == "plasmatic" ? ".cnc" : ".ngc";
}

InputLanguage language_of(const Dialect& dialect) {
  if (dialect.form == Form::ThreeB) return InputLanguage::ThreeB;
  if (dialect.form == Form::Gcode) return InputLanguage::Gcode;
  return dialect.arc_form == ArcForm::Centre ? InputLanguage::EssiIso : InputLanguage::Essi;
}

SourceSettings as_its_control(const Settings& settings) {
  const Dialect& dialect = settings.dialect;
  SourceSettings source = settings.source;
  source.essi.unit = source.three_b.unit = dialect.unit;
  if (language_of(dialect) == InputLanguage::EssiIso) {
    source.essi.dialect = EssiDialect::Iso;
    if (!dialect.plus_is_ccw) source.essi.iso_plus = RotationSense::Clockwise;
  }
  if (dialect.kerf.rounds_corners) source.evaluate.corner = CornerStyle::Round;
  if (dialect.kerf.exist() && dialect.kerf.entry != KerfEntry::Either) {
    const bool meets = dialect.kerf.entry == KerfEntry::Meets;
    set_kerf_lead(source, meets ? KerfLead::Meets : KerfLead::Beside);
  }
  return source;
}

void set_kerf_lead(SourceSettings& source, KerfLead lead) {
  source.essi.nc.kerf_lead = lead;
  source.gcode.nc.kerf_lead = lead;
}

}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/pipeline.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "lang/nc/kerf.h"
#include "lang/poly/toolpath.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> folder_of(const std::string& name) {
  if (name == kStream) return std::nullopt;
  const fs::path folder = fs::path(name).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

std::string lower_extension(const std::string& name) {
  std::string extension = fs::path(name).extension();
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

void compile_dgt(Compilation& made, const std::string& name, const SourceSettings& settings) {
  FolderLoader loader(folder_of(name), {settings.macro_path.begin(), settings.macro_path.end()});
  made.result = compile(*made.file, loader, settings.evaluate, made.bag);
}

void compile_poly(Compilation& made) {
  const std::vector<PolyLoop> loops = read_poly(*made.file, made.bag);
  made.bag.sort();
  if (!made.bag.has_errors()) made.result.path = toolpath_of(loops, *made.file);
}

ContourOptions contour_options(const EvaluateOptions& evaluate) {
  ContourOptions options;
  options.join_tolerance = evaluate.join_tolerance;
  options.gouge = evaluate.gouge;
  options.corner = evaluate.corner;
  options.corner_limit = evaluate.corner_limit;
  return options;
}

void compile_dxf(Compilation& made, const SourceSettings& settings) {
  Toolpath path = read_dxf(*made.file, settings.dxf, contour_options(settings.evaluate), made.bag);
  if (!made.bag.has_errors()) made.result.path = std::move(path);
  made.bag.sort();
}

bool has_kerf(const NcProgram& program) {
  return std::ranges::any_of(program.kerf,
                             [](const KerfSwitch& kerf) { return kerf.side != Side::None; });
}

void finish_nc(Compilation& made, NcProgram program, const EvaluateOptions& evaluate,
               KerfLead lead = KerfLead::Moved) {
  if (!made.bag.has_errors()) {
    made.arcs = std::move(program.arcs);
    made.placed_by = program.placed_by;
    const ContourOptions options = contour_options(evaluate);
    made.has_kerf = has_kerf(program);
    Toolpath path = with_kerf(*made.file, std::move(program), options, made.bag, lead);
    if (!made.bag.has_errors()) made.result.path = std::move(path);
  }
  made.bag.sort();
}

void compile_essi(Compilation& made, const SourceSettings& settings, EssiDialect dialect) {
  EssiOptions options = settings.essi;
  options.dialect = dialect;
  finish_nc(made, read_essi(*made.file, options, made.bag), settings.evaluate,
            options.nc.kerf_lead);
}

void compile_gcode(Compilation& made, const SourceSettings& settings) {
  finish_nc(made, read_gcode(*made.file, settings.gcode, made.bag), settings.evaluate,
            settings.gcode.nc.kerf_lead);
}

void compile_three_b(Compilation& made, const SourceSettings& settings) {
  finish_nc(made, read_three_b(*made.file, settings.three_b, made.bag), settings.evaluate);
}

}  // namespace

std::optional<InputLanguage> language_of(const std::string& name) {
  const std::string extension = lower_extension(name);
  if (name == kStream || extension == ".bgt" || extension == ".dgt") return InputLanguage::Dgt;
  if (extension == ".dxf") return InputLanguage::Dxf;
  if (extension == ".3b") return InputLanguage::ThreeB;
  if (extension == ".poly") return InputLanguage::Poly;
  if (extension == ".ess" || extension == ".essi") return InputLanguage::Essi;
  static constexpr std::array<std::string_view, 5> kGcode = {".nc", ".cnc", ".gcode", ".ngc",
                                                             ".tap"};
  if (std::ranges::find(kGcode, extension) != kGcode.end()) return InputLanguage::Gcode;
  return std::nullopt;
}

std::shared_ptr<const SourceFile> decode_source(const std::string& name, std::string_view bytes,
                                                std::optional<Encoding> encoding) {
  return std::make_shared<const SourceFile>(name == kStream ? "<stdin>" : name, bytes, encoding);
}

Compilation compile_source(const std::string& name, std::shared_ptr<const SourceFile> source,
                           const SourceSettings& settings) {
  Compilation made;
  made.file = std::move(source);
  const InputLanguage by_name = language_of(name).value_or(InputLanguage::Dgt);
  switch (settings.from.value_or(by_name)) {
    case InputLanguage::Dgt:
      compile_dgt(made, name, settings);
      break;
    case InputLanguage::Essi:
      compile_essi(made, settings, settings.essi.dialect);
      break;
    case InputLanguage::EssiIso:
      compile_essi(made, settings, EssiDialect::Iso);
      break;
    case InputLanguage::Gcode:
      compile_gcode(made, settings);
      break;
    case InputLanguage::ThreeB:
      compile_three_b(made, settings);
      break;
    case InputLanguage::Dxf:
      compile_dxf(made, settings);
      break;
    case InputLanguage::Poly:
      compile_poly(made);
      break;
  }
  return made;
}

Compilation compile_bytes(const std::string& name, std::string_view bytes,
                          const SourceSettings& settings) {
  return compile_source(name, decode_source(name, bytes, settings.encoding), settings);
}

FileResult<Compilation> compile_file(const std::string& name, const SourceSettings& settings) {
  auto bytes = read_file(name);
  if (!bytes) return tl::unexpected(bytes.error());
  auto source = decode_source(name, *bytes, settings.encoding);
  bytes = {};  // a large program is not kept twice
  return compile_source(name, std::move(source), settings);
}

}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/device_messages.h"

#include <fmt/format.h>

#include <system_error>

#include "device/run.h"
#include "device/tape.h"

namespace dgt {
namespace {

struct Sentence {
  const char* english;
  const char* russian;
};

/// {device}, {row}, {mm} from the first row, {system}: what the system says, {seconds} of the
/// timeout, {rate} and {speed} in rows a second, {most} rows.
Sentence sentence(DeviceFault::Kind kind) {
  using Kind = DeviceFault::Kind;
  switch (kind) {
    case Kind::CannotOpen:
      return {"{device} cannot be opened: {system}", "{device} не открывается: {system}"};
    case Kind::CannotSetUp:
      return {"{device} does not take its speed or handshake: {system}",
              "{device} не принимает скорость или управление потоком: {system}"};
    case Kind::Failed:
      return {"{device} failed behind row {row}, {mm} mm: {system}",
              "{device}: сбой после строки {row}, {mm} мм: {system}"};
    case Kind::Gone:
      return {"{device}: the line is dead behind row {row}, {mm} mm; power or cable",
              "{device}: связь пропала после строки {row}, {mm} мм; питание или кабель"};
    case Kind::Stalled:
      return {
          "{device}: the punch has taken no row for {seconds} s behind row {row}, {mm} mm; tape "
          "out or torn, or off-line",
          "{device}: перфоратор не принимает строки уже {seconds} с, после строки {row}, {mm} мм; "
          "кончилась или порвалась лента, либо он отключён"};
    case Kind::NoRows:
      return {
          "{device}: the reader has sent nothing for {seconds} s; is a tape in it, is it on-line?",
          "{device}: фотосчитыватель молчит {seconds} с; заправлена ли лента, включён ли он?"};
    case Kind::Silent:
      return {
          "{device}: the reader fell silent behind row {row}, {mm} mm, where no tape ends; stuck "
          "tape, or the reader hangs",
          "{device}: фотосчитыватель замолчал после строки {row}, {mm} мм, где лента не кончается; "
          "застряла лента или завис считыватель"};
    case Kind::Slow:
      return {
          "{device}: {rate} rows a second instead of {speed} at row {row}, {mm} mm; look after the "
          "drive, or set its true speed",
          "{device}: {rate} строк/с вместо {speed} у строки {row}, {mm} мм; проверьте привод или "
          "задайте его настоящую скорость"};
    case Kind::Torn:
      return {
          "{device}: light in all tracks behind row {row}, {mm} mm; the tape is torn or has run "
          "out",
          "{device}: свет на всех дорожках после строки {row}, {mm} мм; лента порвалась или "
          "кончилась"};
    case Kind::TooLong:
      return {"{device}: more than {most} rows; this is no reader of tapes",
              "{device}: больше {most} строк; это не считыватель лент"};
    case Kind::Cancelled:
      break;
  }
  return {"{device}: stopped by hand behind row {row}, {mm} mm",
          "{device}: остановлено вручную после строки {row}, {mm} мм"};
}

}  // namespace

std::string sentence_of(const DeviceFault& fault, const DeviceLimits& limits, Language language) {
  const Sentence texts = sentence(fault.kind);
  const double seconds = std::chrono::duration<double>(limits.timeout).count();
  return fmt::format(fmt::runtime(language == Language::Russian ? texts.russian : texts.english),
                     fmt::arg("device", fault.device), fmt::arg("row", fault.row),
                     fmt::arg("mm", millimetres_to(fault.row)),
                     fmt::arg("system", std::generic_category().message(fault.error)),
                     fmt::arg("seconds", fmt::format("{:g}", seconds)),
                     fmt::arg("rate", fmt::format("{:.0f}", fault.rate)),
                     fmt::arg("speed", limits.speed), fmt::arg("most", kMostRows));
}

}  // namespace dgt

// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/tape_faults.h"

#include <fmt/format.h>

#include <system_error>

namespace dgt::cli {
namespace {

/// A text of the table with its arguments, in the order of the table.
struct Sentence {
  Text text;
  std::vector<std::string> arguments;
};

Sentence told(const DeviceFault& fault, const DeviceLimits& limits) {
  using Kind = DeviceFault::Kind;
  const std::string system = std::generic_category().message(fault.error);
  const std::string row = std::to_string(fault.row);
  const std::string mm = millimetres_to(fault.row);
  const std::string seconds =
      fmt::format("{:g}", std::chrono::duration<double>(limits.timeout).count());
  switch (fault.kind) {
    case Kind::CannotOpen:
      return {Text::DeviceCannotOpen, {fault.device, system}};
    case Kind::CannotSetUp:
      return {Text::DeviceCannotSetUp, {fault.device, system}};
    case Kind::Failed:
      return {Text::DeviceFailed, {fault.device, row, mm, system}};
    case Kind::Gone:
      return {Text::DeviceGone, {fault.device, row, mm}};
    case Kind::Stalled:
      return {Text::DeviceStalled, {fault.device, row, mm, seconds}};
    case Kind::NoRows:
      return {Text::DeviceNoRows, {fault.device, row, mm, seconds}};
    case Kind::Silent:
      return {Text::DeviceSilent, {fault.device, row, mm}};
    case Kind::Slow:
      return {
          Text::DeviceSlow,
          {fault.device, row, mm, fmt::format("{:.0f}", fault.rate), std::to_string(limits.speed)}};
    case Kind::Torn:
      return {Text::DeviceTorn, {fault.device, row, mm}};
    case Kind::TooLong:
      return {Text::DeviceTooLong, {fault.device, std::to_string(kMostRows)}};
    case Kind::Cancelled:
      break;
  }
  return {Text::DeviceCancelled, {fault.device, row, mm}};
}

constexpr std::size_t kMostArguments = 5;

}  // namespace

std::string sentence_of(const DeviceFault& fault, const DeviceLimits& limits,
                        const Console& console) {
  Sentence sentence = told(fault, limits);
  sentence.arguments.resize(kMostArguments);
  const auto& a = sentence.arguments;
  return console.sentence(sentence.text, {a[0], a[1], a[2], a[3], a[4]});
}

ExitCode report(const DeviceFault& fault, const DeviceLimits& limits, const Console& console) {
  console.error(Text::FileFailed, {sentence_of(fault, limits, console)});
  return ExitCode::Failure;
}

}  // namespace dgt::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/essi/subprograms.h"

#include <algorithm>
#include <string>
#include <utility>

#include "lang/essi/frame.h"

namespace dgt::essi {
namespace {

constexpr std::size_t kMaxDepth = 5;

}  // namespace

bool Subprograms::take(const Block& block, bool began_main) {
  if (block.is_mark() && is_subprogram(block.number)) {
    block.fields[0].negative ? close(block) : open(block, began_main);
    return true;
  }
  if (open_ == nullptr) return false;
  open_->blocks.push_back(block);
  return true;
}

void Subprograms::open(const Block& block, bool began_main) {
  const std::string number = std::to_string(block.number);
  const Range range = messages_.range_of(block);
  if (open_ != nullptr) {
    messages_.report(Message::EssiNestedDefinition, range, {number, std::to_string(open_number_)});
  } else if (began_main) {
    messages_.report(Message::EssiDefinedLate, range, {number});
  }
  const auto [entry, is_new] = all_.try_emplace(block.number);
  if (!is_new) {
    Diagnostic fault{Message::EssiDefinedTwice, range, {number}};
    fault.notes.push_back({Message::EssiDefinedHere, entry->second.begin, {number}});
    messages_.add(std::move(fault));
  }
  entry->second = {range, {}};
  open_ = &entry->second;
  open_number_ = block.number;
}

void Subprograms::close(const Block& block) {
  if (open_ == nullptr || open_number_ != block.number) {
    Diagnostic fault{
        Message::EssiNothingToClose, messages_.range_of(block), {std::to_string(block.number)}};
    if (open_ != nullptr) {
      fault.notes.push_back(
          {Message::EssiDefinedHere, open_->begin, {std::to_string(open_number_)}});
    }
    messages_.add(std::move(fault));
  }
  open_ = nullptr;
}

void Subprograms::check() {
  if (open_ != nullptr)
    messages_.report(Message::EssiUnclosed, open_->begin, {std::to_string(open_number_)});
  for (const auto& [number, subprogram] : all_) {
    for (const Block& block : subprogram.blocks) {
      if (block.has_number && is_subprogram(block.number)) (void)called_by(block);
    }
  }
}

const Subprogram* Subprograms::called_by(const Block& block) {
  const auto found = all_.find(block.number);
  if (found != all_.end()) return &found->second;
  messages_.report(Message::EssiUnknownSubprogram, messages_.range_of(block),
                   {std::to_string(block.number)});
  return nullptr;
}

std::optional<CallWords> read_call(const Block& block, const EssiOptions& options,
                                   Messages& messages) {
  CallWords words;
  if (block.count > 3) return messages.refuse(block.fields[3], Message::EssiSurplus), std::nullopt;
  if (block.count > 0) {
    const Field& field = block.fields[0];
    if (field.negative || (field.has_digits && field.value < 1))
      return messages.refuse(field, Message::EssiBadRepetition), std::nullopt;
    if (field.has_digits) words.repetitions = field.value;
  }
  if (block.count > 1) {
    const Field& field = block.fields[1];
    if (field.value < -kWholeTurn || field.value > kWholeTurn)
      return messages.refuse(field, Message::EssiBadAngle), std::nullopt;
    const bool ccw = options.rotation == RotationSense::CounterClockwise;
    words.tenths = ccw ? field.value : -field.value;
  }
  if (block.count > 2) {
    const Field& field = block.fields[2];
    if (field.negative || (field.has_digits && field.value < 1))
      return messages.refuse(field, Message::EssiBadScale), std::nullopt;
    if (field.has_digits)
      words.scale = Rational(static_cast<long>(field.value)) * options.scale_unit;
  }
  return words;
}

bool may_enter(const Block& block, Messages& messages) {
  const std::vector<Call>& calls = messages.calls;
  const auto same = [&](const Call& call) { return call.number == block.number; };
  const auto first = std::find_if(calls.begin(), calls.end(), same);
  if (first != calls.end()) {
    std::string circle;
    for (auto call = first; call != calls.end(); ++call)
      circle += std::to_string(call->number) + " → ";
    circle += std::to_string(block.number);
    messages.report(Message::EssiRecursion, messages.range_of(block),
                    {std::to_string(block.number), circle});
    return false;
  }
  if (calls.size() < kMaxDepth) return true;
  messages.report(Message::EssiTooDeep, messages.range_of(block),
                  {std::to_string(calls.size() + 1), std::to_string(kMaxDepth)});
  return false;
}

}  // namespace dgt::essi

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <variant>

#include "kernel/circle.h"
#include "kernel/line.h"

namespace dgt {

/// What contours run along.
using Element = std::variant<Line, Circle>;

/// Where an element comes from that many share.
class ElementSource {
 public:
  ElementSource() = default;
  ElementSource(const ElementSource&) = delete;
  ElementSource& operator=(const ElementSource&) = delete;
  virtual ~ElementSource() = default;
  /// The same object in every call.
  [[nodiscard]] virtual const Element& element() const = 0;
};

/// An element that is worked out when it is first asked for. Threads may ask at once.
///
/// An NC program has millions of arcs, told in a few whole numbers each; their circles are ten
/// times as large, and a program that is only read never asks for them.
class ElementOnDemand : public ElementSource {
 public:
  ~ElementOnDemand() override { delete made_.load(std::memory_order_acquire); }
  [[nodiscard]] const Element& element() const final;
  [[nodiscard]] bool is_made() const { return made_.load(std::memory_order_acquire) != nullptr; }

 private:
  /// The same value in every call.
  [[nodiscard]] virtual Element make() const = 0;

  mutable std::atomic<const Element*> made_{nullptr};
};

/// A shared element, or none. Equal where both share one, not where two have the same value.
class ElementPtr {
 public:
  ElementPtr() = default;
  ElementPtr(std::nullptr_t) {}  // NOLINT: none, as of any pointer
  explicit ElementPtr(Element element);
  explicit ElementPtr(std::shared_ptr<const ElementSource> source) : source_(std::move(source)) {}

  [[nodiscard]] const Element* get() const { return source_ ? &source_->element() : nullptr; }
  [[nodiscard]] const Element& operator*() const { return source_->element(); }
  [[nodiscard]] const Element* operator->() const { return &source_->element(); }
  [[nodiscard]] explicit operator bool() const { return source_ != nullptr; }
  [[nodiscard]] const std::shared_ptr<const ElementSource>& source() const { return source_; }

  friend bool operator==(const ElementPtr&, const ElementPtr&) = default;

 private:
  std::shared_ptr<const ElementSource> source_;
};

[[nodiscard]] Element reversed(const Element& e);
[[nodiscard]] Element offset(const Element& e, const Rational& distance);

/// −1 right of the element's direction, 0 on it, +1 left of it; exactly.
[[nodiscard]] int side_of(const Element& e, const ExactPoint& q);
/// The distance from `q` to the element, in mm, for messages: correctly rounded for lines, within a
/// few units in the last place for circles.
[[nodiscard]] double distance_to(const Element& e, const ExactPoint& q);

/// An element moved sideways by an exact distance: what a cut runs on. The offset element is made
/// when asked for, since most of a program's decisions need its filter values alone.
struct Carrier {
  ElementPtr base;
  std::shared_ptr<const Rational> shift;  ///< to the left, in mm; null for 0

  [[nodiscard]] Element element() const { return shift ? offset(*base, *shift) : *base; }
  [[nodiscard]] bool is_line() const { return std::holds_alternative<Line>(*base); }
};

}  // namespace dgt

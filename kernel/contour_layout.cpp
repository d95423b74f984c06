// SPDX-License-Identifier: GPL-3.0-or-later
// Items to legs: one pass over the items with three things in hand: the joint where the tool
// stands, the element it is about to run along (`along_`), and what waits for its second element (a
// fillet or bevel, a selector, an axis).
#include <utility>

#include "kernel/construct_bounds.h"
#include "kernel/contour_legs.h"

namespace dgt {
namespace {

using Kind = ContourFault::Kind;

class Layout {
 public:
  Layout(const std::vector<ContourItem>& items, ToolState& state, const ContourOptions& options)
      : items_(items), state_(state), options_(options) {
    out_.joints.push_back({FixedJoint{state.at}, state.at});
  }

  ContourLegs run() {
    for (item_ = 0; item_ < items_.size(); ++item_)
      std::visit([this](const auto& what) { take(what); }, items_[item_].what);
    item_ = items_.empty() ? 0 : items_.size() - 1;
    if (blend_item_) report(Kind::NothingToJoin, *blend_item_);
    if (selector_item_) report(Kind::UnusedSelector, *selector_item_);
    if (out_.offset_given && !out_.first_element) out_.steps.assign(1, Rational(0));
    return std::move(out_);
  }

 private:
  /// The element the tool runs along next.
  struct Along {
    UsedElement element;
    bool positioned = true;  ///< false for the first of a first pair: the tool is not on it yet
    bool travelled = false;  ///< a D ended a leg here: a point is then gone to straight
  };

  // --- items ----------------------------------------------------------------------------------

  void take(const AlongItem& item) {
    const UsedElement next{item.element, step_, item_};
    if (!out_.first_element) {
      out_.first_element = next;
      out_.tool_before = here();
    }
    const bool joined = along_ ? join(next) : arrive(next);
    blend_item_.reset();
    clear_selector();
    if (!joined) {
      // Go on as if the tool stood at the beginning of the element: what follows is checked alone.
      along_ = Along{next, false, false};
    }
  }

  void take(const PointItem& item) {
    if (refuse_blend()) return;
    if (along_ && !along_->travelled) {
      if (!depart(item.at)) return;
    } else {
      straight(FixedJoint{item.at}, item.at, first_straight_ ? Role::Position : Role::Contour);
    }
    along_.reset();
    axis_.reset();
    at_point_ = true;
  }

  void take(const AxisItem& item) {
    if (refuse_blend()) return;
    if (along_) {
      if (!end_at_axis(item.line)) return;
      along_.reset();
    }
    at_point_ = false;
    axis_ = std::pair(item.line, item_);
  }

  void take(const FilletItem& item) { wait_for_second(item); }
  void take(const BevelItem& item) { wait_for_second(item); }

  void take(const TravelItem& item) {
    if (!along_) return report(Kind::NothingToJoin, item_);
    if (refuse_blend()) return;
    const auto* line = std::get_if<Line>(along_->element.element.get());
    if (!line) return report(Kind::TravelOnCircle, along_->element.item, item_);
    if (!along_->positioned) {
      if (!lies_on(*line, here())) {
        return report(Kind::OffElement, along_->element.item, item_,
                      distance_to(*line, here().exact()));
      }
      straight(BesideJoint{here(), along_->element}, here(), Role::LeadIn);
    }
    const ExactPoint begin = here().exact();
    const Vector way = item.distance * line->direction().vector();
    const Point end(ExactPoint(begin.x + way.x, begin.y + way.y));
    run_along(along_->element, BesideJoint{end, along_->element}, end, Role::Contour);
    along_->positioned = true;
    along_->travelled = true;
  }

  void take(const OffsetItem& item) {
    if (!item.whole_contour) {
      out_.steps.push_back(item.distance);
      step_ = out_.steps.size() - 1;
      return;
    }
    if (out_.offset_given || out_.first_element) return report(Kind::OffsetTwice, item_);
    out_.offset_given = true;
    out_.steps.front() = item.distance;
  }

  void take(const SelectItem& item) {
    if (selector_item_) report(Kind::UnusedSelector, *selector_item_);
    selector_ = item.selector;
    selector_item_ = item_;
  }

  void take(const RapidItem&) { rapid_once_ = true; }

  void take(const FeedItem& item) {
    state_.straight_rapid = sgn(item.feed) == 0;
    if (!state_.straight_rapid) state_.feed = shared(item.feed);
  }

  void take(const HeightItem& item) { height_ = shared(item.z); }

  void take(const DwellItem& item) { stop().seconds = shared(item.seconds); }
  void take(const CodeItem& item) { stop().code = item.code; }

  void take(const ThreadItem& item) {
    const Point at(item.at);
    along_.reset();
    axis_.reset();
    at_point_ = false;
    if (!state_.moved && out_.joints.size() == 1) {
      state_.start = item.at;
      out_.joints.front() = {FixedJoint{at}, at};
      return;
    }
    Leg& leg = straight(FixedJoint{at}, at, Role::Thread);
    leg.rapid = true;
  }

  // --- joints ---------------------------------------------------------------------------------

  /// From the element under way to the next.
  bool join(const UsedElement& next) {
    const UsedElement first = along_->element;
    if (blend_item_) return blend(first, next);
    auto joint = crossing(first, next);
    if (!joint) return false;
    reach(first, std::move(*joint), Role::Contour);
    along_ = Along{next, true, false};
    return true;
  }

  /// Onto an element from where the tool stands: along the normal, at an axis, or as the first of a
  /// pair that only positions.
  bool arrive(const UsedElement& next) {
    if (blend_item_) {
      report(Kind::NothingToJoin, *blend_item_);
      return false;
    }
    if (at_point_) {
      if (!foot_defined(next)) return false;
      const Point from = here();
      const Point foot(foot_of_normal(*next.element, from));
      straight(FootJoint{from, next}, foot, Role::LeadIn);
    } else if (axis_) {
      const UsedElement axis{axis_->first, 0, axis_->second};
      auto joint = axis_joint(next, axis, Which::Entry);
      if (!joint) return false;
      straight(std::move(joint->rule), joint->programmed, Role::LeadIn);
    } else {
      along_ = Along{next, false, false};
      return true;
    }
    axis_.reset();
    at_point_ = false;
    along_ = Along{next, true, false};
    return true;
  }

  /// Off the element along the normal through `to`.
  bool depart(const Point& to) {
    const UsedElement& from = along_->element;
    const auto* circle = std::get_if<Circle>(from.element.get());
    if (circle && Point(circle->centre()) == to) {
      report(Kind::CentreApproach, from.item, item_);
      along_.reset();
      return false;
    }
    const Point foot(foot_of_normal(*from.element, to));
    reach(from, {FootJoint{to, from}, foot}, Role::Contour);
    straight(FixedJoint{to}, to, Role::LeadOut);
    return true;
  }

  bool end_at_axis(const ElementPtr& axis) {
    const UsedElement from = along_->element;
    // The axis leaves the disc of a circle under way; a line under way meets it anywhere.
    auto joint = axis_joint(from, {axis, 0, item_}, Which::Exit);
    clear_selector();
    if (!joint) {
      along_.reset();
      return false;
    }
    reach(from, std::move(*joint), Role::Contour);
    return true;
  }

  bool blend(const UsedElement& first, const UsedElement& next) {
    if (std::holds_alternative<FilletItem>(items_[*blend_item_].what) ||
        !std::get<BevelItem>(items_[*blend_item_].what).leg) {
      if (out_.steps[first.step] != out_.steps[next.step]) {
        report(Kind::OffsetAtTangent, *blend_item_, next.item);
        return false;
      }
    }
    auto made = make_blend(first, next);
    if (auto* fault = std::get_if<ContourFault>(&made)) {
      fault->item = first.item;
      fault->other = next.item;
      out_.faults.push_back(*fault);
      return false;
    }
    const Blend& between = std::get<Blend>(made);
    const UsedElement middle{between.element, first.step, *blend_item_};
    auto begin = between.tangent ? tangent(first, middle) : crossing(first, middle);
    auto end = between.tangent ? tangent(middle, next) : crossing(middle, next);
    if (!begin || !end) return false;
    reach(first, std::move(*begin), Role::Contour);
    run_along(middle, std::move(end->rule), end->programmed, blend_role());
    along_ = Along{next, true, false};
    return true;
  }

  std::variant<Blend, ContourFault> make_blend(const UsedElement& first, const UsedElement& next) {
    const ContourItem& item = items_[*blend_item_];
    if (const auto* fillet = std::get_if<FilletItem>(&item.what)) {
      const bool known =
          selector_ == Selector::Default || selector_ == Selector::I1 || selector_ == Selector::I2;
      if (!known) {
        ContourFault fault{};
        fault.kind = Kind::NoChoice;
        return fault;
      }
      const bool next_one = selector_ == Selector::I2;
      use_selector();
      return fillet_between(*first.element, *next.element, fillet->radius,
                            along_->positioned ? std::optional(here()) : std::nullopt, next_one);
    }
    const auto& bevel = std::get<BevelItem>(item.what);
    return bevel.leg ? chamfer_between(*first.element, *next.element, *bevel.leg)
                     : tangent_between(*first.element, *next.element);
  }

  Role blend_role() const {
    const ContourItem& item = items_[*blend_item_];
    if (std::holds_alternative<FilletItem>(item.what)) return Role::Fillet;
    return std::get<BevelItem>(item.what).leg ? Role::Chamfer : Role::Tangent;
  }

  static std::optional<Joint> tangent(const UsedElement& a, const UsedElement& b) {
    return Joint{TangentJoint{a, b}, Point(contact(*a.element, *b.element))};
  }

  /// I1 of a pair: the first enters the disc of the second; a circle is left where the line leaves
  /// it.
  static Which first_choice(const Element& a, const Element& b) {
    const bool leaving = std::holds_alternative<Circle>(a) && std::holds_alternative<Line>(b);
    return leaving ? Which::Exit : Which::Entry;
  }

  std::optional<Joint> crossing(const UsedElement& a, const UsedElement& b) {
    CrossJoint rule{a, b, first_choice(*a.element, *b.element)};
    if (!decide(a, b, rule.which)) return std::nullopt;
    return placed(rule);
  }

  std::optional<Joint> axis_joint(const UsedElement& on, const UsedElement& axis,
                                  Which circle_choice) {
    AxisJoint rule{on, axis.element, circle_choice};
    if (!decide(on, axis, rule.which)) return std::nullopt;
    return placed(rule);
  }

  /// Settles which crossing is meant, on the programmed contour, once and for all.
  bool decide(const UsedElement& a, const UsedElement& b, Which& which) {
    if (selector_ == Selector::Default) return true;
    use_selector();
    const Meeting meeting = meet(Carrier{a.element, nullptr}, Carrier{b.element, nullptr});
    if (const auto* two = std::get_if<TwoPoints>(&meeting)) {
      const auto chosen = choose(*two, which, selector_);
      if (std::holds_alternative<Impossible>(chosen)) {
        report(Kind::EqualCandidates, a.item, b.item);
        return false;
      }
      which = std::get<Which>(chosen);
      return true;
    }
    const auto* one = std::get_if<OnePoint>(&meeting);
    if (one && !one->contact) {
      report(Kind::NoChoice, a.item, b.item);
      return false;
    }
    return true;  // a contact is both; what does not meet is reported where it is placed
  }

  template <class Rule>
  std::optional<Joint> placed(const Rule& rule) {
    const Shifts none(out_.steps.size());
    const PlacedJoint at = place_joint({rule, {}}, none, options_);
    if (at.fault) {
      out_.faults.push_back(*at.fault);
      return std::nullopt;
    }
    if (at.notice) out_.notices.push_back(*at.notice);
    return Joint{rule, *at.at};
  }

  bool foot_defined(const UsedElement& on) {
    const auto* circle = std::get_if<Circle>(on.element.get());
    if (!circle || !(Point(circle->centre()) == here())) return true;
    report(Kind::CentreApproach, on.item, item_);
    return false;
  }

  // --- legs -----------------------------------------------------------------------------------

  const Point& here() const { return out_.joints[stands_].programmed; }

  /// To `joint`, along the element when the tool is on it, straight when it is yet to be
  /// positioned.
  void reach(const UsedElement& element, Joint joint, Role role) {
    if (along_->positioned)
      run_along(element, std::move(joint.rule), joint.programmed, role);
    else
      straight(std::move(joint.rule), joint.programmed, Role::LeadIn);
  }

  template <class Rule>
  void run_along(const UsedElement& element, Rule rule, const Point& programmed, Role role) {
    const bool foot_to_foot = std::holds_alternative<FootJoint>(out_.joints[stands_].rule);
    const std::size_t from = stands_;
    Leg& leg = add(Leg::Travel::Along, std::move(rule), programmed, role);
    leg.element = element;
    const bool is_line = std::holds_alternative<Line>(*element.element);
    leg.rapid = state_.straight_rapid && is_line;
    if (state_.straight_rapid && !is_line) report(Kind::RapidArc, element.item);
    leg.full_circle = !is_line && foot_to_foot &&
                      std::holds_alternative<FootJoint>(out_.joints[leg.to].rule) &&
                      out_.joints[from].programmed == out_.joints[leg.to].programmed;
  }

  template <class Rule>
  Leg& straight(Rule rule, const Point& programmed, Role role) {
    Leg& leg = add(Leg::Travel::Straight, std::move(rule), programmed, role);
    leg.rapid = rapid_once_ || state_.straight_rapid;
    rapid_once_ = false;
    first_straight_ = false;
    return leg;
  }

  template <class Rule>
  Leg& add(Leg::Travel travel, Rule rule, const Point& programmed, Role role) {
    out_.joints.push_back({std::move(rule), programmed});
    Leg& leg = out_.legs.emplace_back();
    leg.travel = travel;
    leg.role = role;
    leg.from = stands_;
    leg.to = stands_ = out_.joints.size() - 1;
    leg.feed = state_.feed;
    leg.z = std::exchange(height_, nullptr);
    // A stretch along an element belongs to the word that names it; a straight one to the word that
    // asks for it.
    leg.place = items_[travel == Leg::Travel::Along && along_ ? along_->element.item : item_].place;
    if (role == Role::Fillet || role == Role::Chamfer || role == Role::Tangent)
      leg.place = items_[*blend_item_].place;
    return leg;
  }

  Leg& stop() {
    Leg& leg = out_.legs.emplace_back();
    leg.travel = Leg::Travel::Stop;
    leg.from = leg.to = stands_;
    leg.place = items_[item_].place;
    return leg;
  }

  // --- what waits -----------------------------------------------------------------------------

  template <class Item>
  void wait_for_second(const Item&) {
    if (blend_item_ || !along_) return report(Kind::NothingToJoin, item_);
    blend_item_ = item_;
  }

  bool refuse_blend() {
    if (!blend_item_) return false;
    report(Kind::NothingToJoin, *blend_item_);
    blend_item_.reset();
    along_.reset();
    return true;
  }

  void use_selector() { selector_item_.reset(); }

  /// A selector that no joint asked for selects nothing.
  void clear_selector() {
    if (selector_item_ && along_ && along_->positioned) {
      report(Kind::UnusedSelector, *selector_item_);
      selector_item_.reset();
    }
    if (!selector_item_) selector_ = Selector::Default;
  }

  void report(Kind kind, std::size_t item, std::size_t other_item = 0, double measure = 0) {
    ContourFault fault{};
    fault.kind = kind;
    fault.item = item;
    fault.other = other_item;
    fault.measure = measure;
    out_.faults.push_back(fault);
  }

  const std::vector<ContourItem>& items_;
  ToolState& state_;
  const ContourOptions& options_;
  ContourLegs out_;

  std::size_t item_ = 0;
  std::size_t stands_ = 0;  ///< joint where the tool stands
  std::size_t step_ = 0;    ///< offset step in force
  std::optional<Along> along_;
  bool at_point_ = false;  ///< the tool stands at a point of this contour: normals start here
  std::optional<std::pair<ElementPtr, std::size_t>> axis_;
  std::optional<std::size_t> blend_item_;
  Selector selector_ = Selector::Default;
  std::optional<std::size_t> selector_item_;
  bool rapid_once_ = false;
  bool first_straight_ = true;
  RationalPtr height_;
};

}  // namespace

ContourLegs lay_out(const std::vector<ContourItem>& items, ToolState& state,
                    const ContourOptions& options) {
  return Layout(items, state, options).run();
}

}  // namespace dgt

#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/trajectory.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix {

/// The largest difference of a quantity of two trajectories, and when.
template <Unit U> struct LargestDifference {
  Quantity<U> size;
  Quantity<si::time> time;
};

namespace detail {

struct NumberDifference {
  double size, time;
};
struct EventTime {
  std::string name;
  double time;
};

/// The largest differences of the states of one craft. That of a vector or a quaternion stands where its
/// first number is in the state: the length of the difference, or the angle of the rotation between.
class VECTRIX_EXPORT StateDifferences {
 public:
  StateDifferences(std::shared_ptr<const CraftCore> core, double from, double until);
  void add(double t, const double* ours, const double* theirs);
  void set_events(std::vector<EventTime> ours, std::vector<EventTime> theirs);
  /// The times of impulses within the span, in order. If there are as many of both, the states from an
  /// impulse to that of the other trajectory are not compared: only one has been struck.
  void set_impulses(const std::vector<double>& ours, const std::vector<double>& theirs);
  bool is_between_impulses(double t) const;

  const NumberDifference& at(std::size_t number) const { return numbers_[number]; }
  const NumberDifference& energy() const { return energy_; }
  const NumberDifference& momentum() const { return momentum_; }
  const NumberDifference& angular_momentum() const { return angular_momentum_; }
  const std::optional<NumberDifference>& events() const { return events_; }
  const std::optional<NumberDifference>& impulses() const { return impulses_; }
  double from() const { return from_; }
  double until() const { return until_; }
  void print(std::ostream& out) const;

 private:
  /// One row of the table: what is compared, its unit, and how many numbers from `at` on it has in a state.
  struct Row {
    std::string name, unit;
    std::size_t at, count;
  };
  void list_rows();

  std::shared_ptr<const CraftCore> core_;
  double from_, until_;
  multibody::Work<double> our_work_, their_work_;
  std::vector<Row> rows_;
  std::vector<NumberDifference> numbers_;
  NumberDifference energy_, momentum_, angular_momentum_;
  std::optional<NumberDifference> events_, impulses_;
  std::size_t our_events_ = 0, their_events_ = 0;
  std::size_t our_impulses_ = 0, their_impulses_ = 0;
  std::vector<std::array<double, 2>> between_impulses_;  // from the first of both to the second
};

}  // namespace detail

/// How far two trajectories of a craft are apart, at all nodes of both: printed, a table with one row for
/// each quantity. Made by compare().
template <CraftType C> class CraftComparison {
  using Shape = typename C::shape;
  template <class B> static constexpr bool is_hub = std::is_same_v<B, typename Shape::hub>;
  template <class B> static constexpr bool moves_freely = Shape::template has_joint_of<B, JointKind::free>;
  template <class B>
  static constexpr bool turns_freely =
      is_hub<B> || Shape::template has_joint_of<B, JointKind::ball> || moves_freely<B>;
  template <class B> static constexpr bool has_place = (is_hub<B> && Shape::free) || moves_freely<B>;

 public:
  CraftComparison(detail::Trusted, detail::StateDifferences differences)
      : differences_(std::move(differences)) {}

  /// The time span that both have.
  Quantity<si::time> from() const { return Quantity<si::time>::from_value(differences_.from()); }
  Quantity<si::time> until() const { return Quantity<si::time>::from_value(differences_.until()); }

  /// Of the hub in the inertial frame, or of a body on a ball joint or a free one on its parent: the angle
  /// between the attitudes, |w - w'|, |r - r'|, |v - v'|, as they are in the state.
  template <class B>
    requires turns_freely<B> LargestDifference<si::angle> attitude(Of<B>)
  const { return typed<si::angle>(differences_.at(is_hub<B> ? 0 : position_at<B>)); }
  template <class B>
    requires turns_freely<B> LargestDifference<si::angular_velocity> rate(Of<B>)
  const { return typed<si::angular_velocity>(differences_.at(is_hub<B> ? 4 : speed_at<B>)); }
  template <class B>
    requires has_place<B> LargestDifference<si::length> position(Of<B>)
  const { return typed<si::length>(differences_.at(is_hub<B> ? 7 : position_at<B> + 4)); }
  template <class B>
    requires has_place<B> LargestDifference<si::velocity> velocity(Of<B>)
  const { return typed<si::velocity>(differences_.at(is_hub<B> ? 10 : speed_at<B> + 3)); }
  template <class B>
  auto attitude(  // of the hub, or of a body of the craft C on a ball joint or a free one
      Of<B>) const -> Refused = delete;
  template <class B>
  auto rate(  // of the hub, or of a body of the craft C on a ball joint or a free one
      Of<B>) const -> Refused = delete;
  template <class B>
  auto position(  // of a hub that is free_in<I>, or of a body of the craft C on a free joint
      Of<B>) const -> Refused = delete;
  template <class B>
  auto velocity(  // of a hub that is free_in<I>, or of a body of the craft C on a free joint
      Of<B>) const -> Refused = delete;

  /// Of a hinge or a slider; the larger of both axes of a gimbal.
  template <class B>
  requires Shape::template has_axes<B> auto coordinate(Of<B>) const {
    return of_axes<typename detail::JointUnits<kind<B>>::coordinate, B>(position_at<B>);
  }
  template <class B>
  requires Shape::template has_axes<B> auto speed(Of<B>) const {
    return of_axes<typename detail::JointUnits<kind<B>>::speed, B>(speed_at<B>);
  }
  template <class B>
  auto coordinate(  // of a hinge, a slider or a gimbal: of a body of the craft C that hangs on one
      Of<B>) const -> Refused = delete;
  template <class B>
  auto speed(  // of a hinge, a slider or a gimbal: of a body of the craft C that hangs on one
      Of<B>) const -> Refused = delete;

  template <class W>
  requires Shape::template has_rotor<W> LargestDifference<si::angular_velocity> spin(Of<W>) const {
    return typed<si::angular_velocity>(differences_.at(Shape::template spin_at<W>));
  }
  template <class W> auto spin(Of<W>) const -> Refused = delete;  // of a rotor of the craft C

  /// As Now has them.
  LargestDifference<si::energy> energy() const { return typed<si::energy>(differences_.energy()); }
  LargestDifference<si::momentum> momentum() const { return typed<si::momentum>(differences_.momentum()); }
  LargestDifference<si::angular_momentum> angular_momentum() const {
    return typed<si::angular_momentum>(differences_.angular_momentum());
  }
  /// Of the times of the events; empty if their names, in order, are not the same, neither of all events nor
  /// of those within the span.
  std::optional<LargestDifference<si::time>> events() const {
    if (!differences_.events()) return std::nullopt;
    return typed<si::time>(*differences_.events());
  }
  /// Of the times of impulses, as of a latch; empty if the two have not the same number of them.
  std::optional<LargestDifference<si::time>> impulses() const {
    if (!differences_.impulses()) return std::nullopt;
    return typed<si::time>(*differences_.impulses());
  }

  friend std::ostream& operator<<(std::ostream& out, const CraftComparison& comparison) {
    comparison.differences_.print(out);
    return out;
  }

 private:
  template <class B> static constexpr JointKind kind = Shape::template Part<B>::joint;
  template <class B> static constexpr std::size_t position_at = Shape::template position_at<B>;
  template <class B> static constexpr std::size_t speed_at = Shape::template speed_at<B>;

  template <Unit U> static LargestDifference<U> typed(const detail::NumberDifference& found) {
    return {Quantity<U>::from_value(found.size), Quantity<si::time>::from_value(found.time)};
  }
  template <Unit U, class B> LargestDifference<U> of_axes(std::size_t at) const {
    const auto first = typed<U>(differences_.at(at));
    if constexpr (kind<B> != JointKind::gimbal) {
      return first;
    } else {
      const auto second = typed<U>(differences_.at(at + 1));
      return second.size > first.size ? second : first;
    }
  }

  detail::StateDifferences differences_;
};

namespace detail {

/// The number of the node before each impulse within the span; the node after it has the same time.
template <CraftType C, class... X>
std::vector<std::size_t> before_impulses(const CraftTrajectory<C, X...>& trajectory,
                                         const Quantity<si::time>& from, const Quantity<si::time>& until) {
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i < trajectory.node_count(); ++i) {
    const auto before = trajectory.node(i - 1), after = trajectory.node(i);
    if (after.time() != before.time() || after.time() < from || after.time() > until) continue;
    if (!std::equal(before.data(), before.data() + C::state_size, after.data())) found.push_back(i - 1);
  }
  return found;
}

}  // namespace detail

/// Two trajectories of a craft, by different methods or engines, at the nodes of both within the time span
/// that both have; before and after an impulse, each at its own time of it, if both have as many impulses.
/// Throws BadInput if they have no span in common, or if one was made without its dense output.
template <CraftType C, class... X, class... Y>
CraftComparison<C> compare(const C& craft, const CraftTrajectory<C, X...>& ours,
                           const CraftTrajectory<C, Y...>& theirs) {
  if (ours.node_count() == 0 || theirs.node_count() == 0)
    throw BadInput("compare: a trajectory of " + plain(craft).hub + " has no node");
  const auto from = std::max(ours.start(), theirs.start()), until = std::min(ours.end(), theirs.end());
  if (!(from <= until)) {
    throw BadInput("compare: the trajectories of " + plain(craft).hub + " end at " +
                   detail::text(until.value()) + " s, before " + detail::text(from.value()) +
                   " s, where the later starts");
  }
  detail::StateDifferences differences(craft.core(), from.value(), until.value());
  const auto at = [&](const char* which, const auto& trajectory, const Quantity<si::time>& t) {
    try {
      return trajectory.at(t);
    } catch (const BadInput&) {
      throw BadInput("compare: the " + std::string{which} + " trajectory of " + plain(craft).hub +
                     " has no state at " + detail::text(t.value()) +
                     " s, a node of the other: it was made without dense_output");
    }
  };
  const auto our_impulses = detail::before_impulses(ours, from, until),
             their_impulses = detail::before_impulses(theirs, from, until);
  const auto times_of = [](const auto& trajectory, const std::vector<std::size_t>& nodes) {
    std::vector<double> times;
    for (const std::size_t i : nodes) times.push_back(trajectory.node(i).time().value());
    return times;
  };
  differences.set_impulses(times_of(ours, our_impulses), times_of(theirs, their_impulses));
  if (our_impulses.size() == their_impulses.size()) {
    for (std::size_t k = 0; k < our_impulses.size(); ++k) {
      for (const std::size_t after : {std::size_t{0}, std::size_t{1}}) {
        const auto state = ours.node(our_impulses[k] + after);
        differences.add(state.time().value(), state.data(), theirs.node(their_impulses[k] + after).data());
      }
    }
  }
  const auto at_nodes_of = [&](const auto& trajectory) {
    for (std::size_t i = 0; i < trajectory.node_count(); ++i) {
      const Quantity<si::time> t = trajectory.node(i).time();
      if (t >= from && t <= until && !differences.is_between_impulses(t.value()))
        differences.add(t.value(), at("first", ours, t).data(), at("second", theirs, t).data());
    }
  };
  at_nodes_of(ours);
  at_nodes_of(theirs);
  const auto events_of = [](const auto& trajectory) {
    std::vector<detail::EventTime> events;
    for (const CraftEvent<C>& event : trajectory.events())
      events.push_back({event.name, event.state.time().value()});
    return events;
  };
  differences.set_events(events_of(ours), events_of(theirs));
  return {detail::trusted, std::move(differences)};
}
template <CraftType C, CraftType OurC, class... X, CraftType TheirC, class... Y>
  requires(!(std::is_same_v<C, OurC> && std::is_same_v<C, TheirC>))
auto compare(  // compare(craft, ours, theirs): two trajectories of the craft C
    const C&, const CraftTrajectory<OurC, X...>&, const CraftTrajectory<TheirC, Y...>&) -> Refused = delete;

}  // namespace vectrix

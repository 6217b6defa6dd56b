#pragma once

#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>
#include <vectrix/dynamics/craft/changes.hpp>
#include <vectrix/dynamics/load/act.hpp>
#include <vectrix/dynamics/load/finite.hpp>

namespace vectrix {

/// When a thruster is commanded on.
struct FiringInterval {
  Quantity<si::time> start, end;
};
/// The time constants with which the thrust rises and falls; 0: at once.
struct ThrustResponse {
  Quantity<si::time> rise, fall;
};

/// The held value of a thruster, since its last switch: the level x of its thrust goes to 1 or 0 as
///     x(t) = x_1 + (x_0 - x_1) exp(-(t - t_0)/T)
template <class On> class Firing {
 public:
  Firing() = default;
  Firing(const ThrustResponse& response, const Quantity<si::force>& thrust)
      : response_(response), thrust_(thrust) {}

  bool is_on() const { return switches_ % 2 == 1; }
  std::size_t switches() const { return switches_; }
  /// The thrust as a part of the full one, at a time until the next switch.
  double level(const Quantity<si::time>& time) const { return target() + (level_ - target()) * left(time); }
  /// The integral of the thrust over the time since the first interval. Over the exhaust velocity it is the
  /// mass used.
  Quantity<si::momentum> impulse(const Quantity<si::time>& time) const { return thrust_ * seconds(time); }

  /// After a switch at the time.
  Firing switched(const Quantity<si::time>& time) const {
    Firing next = *this;
    next.level_ = level(time);
    next.seconds_ = seconds(time);
    next.since_ = time;
    ++next.switches_;
    return next;
  }

 private:
  double target() const { return is_on() ? 1.0 : 0.0; }
  double constant() const { return (is_on() ? response_.rise : response_.fall).value(); }
  double left(const Quantity<si::time>& time) const {
    if (switches_ == 0) return 1.0;
    return constant() > 0.0 ? std::exp(-(time - since_).value() / constant()) : 0.0;
  }
  Quantity<si::time> seconds(const Quantity<si::time>& time) const {
    if (switches_ == 0) return seconds_;
    const double rest = (level_ - target()) * constant() * (1.0 - left(time));
    return seconds_ + Quantity<si::time>::from_value(target() * (time - since_).value() + rest);
  }

  ThrustResponse response_{};
  Quantity<si::force> thrust_{};
  std::size_t switches_ = 0;
  Quantity<si::time> since_{}, seconds_{};
  double level_ = 0.0;
};

namespace detail {

/// The switches, on and off in turn. Throws BadInput unless they are finite and increase.
VECTRIX_EXPORT std::vector<Quantity<si::time>> switches_of(const std::vector<FiringInterval>& intervals);

}  // namespace detail

/// A thruster with its intervals. Made by thruster().
template <CraftType C, class On, class D> struct ThrusterLoad {
  Vector<D, si::force> full_d;
  ThrustResponse response;
  std::vector<Quantity<si::time>> switches;

  /// After all switches before the time.
  Firing<On> before(const Quantity<si::time>& time) const {
    Firing<On> firing(response, norm(full_d));
    for (const auto& at : switches)
      if (at < time) firing = firing.switched(at);
    return firing;
  }

  template <std::size_t> auto parts() const {
    using State = Firing<On>;
    const auto load = [full_d = full_d]<class S>(const Now<C, S>& now, Forces<C, S>& forces,
                                                 const State& firing) {
      forces.force(of<On>, firing.level(now.time()) * full_d);
    };
    const auto at_first = [thruster = *this](const Now<C>& now) { return thruster.before(now.time()); };
    // What is held at the start of a run does not know the switches before it.
    const auto switched = [thruster = *this](const Now<C>& now, const State& firing) {
      return (firing.switches() == 0 ? thruster.before(now.time()) : firing).switched(now.time());
    };
    return std::tuple{held(before(switches.front())), load, at_start(at_first), at_times(switches, switched)};
  }
};

/// A thruster on a body or mount b, through its origin: its full force in a frame of the craft, and the
/// intervals in which it is on. The thrust rises and falls exponentially with the given time constants, and
/// goes on from where it is at each switch; no step crosses one. Firing<On> is held, which has the impulse.
/// The mass of the craft stays what it is. Throws BadInput for a number that is not finite, a negative time
/// constant, no interval, or intervals that do not increase.
template <CraftType C, class On, class D>
  requires detail::acts_on<C, On, Vector<D, si::force>> ThrusterLoad<C, On, D> thruster(
      const C&, Of<On>, const Vector<D, si::force>& full_d, const ThrustResponse& response,
      const std::vector<FiringInterval>& intervals) {
    detail::finite("thruster", "full force", full_d);
    detail::not_negative("thruster", "time constant of the rise", response.rise);
    detail::not_negative("thruster", "time constant of the fall", response.fall);
    return {full_d, response, detail::switches_of(intervals)};
  }
template <class C, class On, class Force>
auto thruster(  // F in N in a frame of C, on a body or mount of C; then {rise, fall}, {{start, end}, ...}
    const C&, Of<On>, const Force&, const ThrustResponse&, const std::vector<FiringInterval>&)
    -> Refused = delete;

}  // namespace vectrix

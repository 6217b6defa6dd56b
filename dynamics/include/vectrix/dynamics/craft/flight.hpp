#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/craft_scenario.hpp>
#include <vectrix/dynamics/craft/ticks.hpp>
#include <vectrix/dynamics/craft/trajectory.hpp>
#include <vectrix/dynamics/multibody/impulse.hpp>

namespace vectrix::detail {

/// What a run keeps of a part that ticks: when, how many ticks it has seen and applied, and what it has found
/// that is not yet in effect.
template <class Part> struct Running;
template <class Trigger, class F> struct Running<Change<Trigger, F>> {
  Running(const Change<Trigger, F>& change, double start, double end)
      : list(ticks(change.trigger, start, end)) {}

  TickList list;
  std::size_t sampled = 0, applied = 0;
  std::vector<typename UpdateOf<F>::result> waiting;
};

template <class HeldTuple> struct HistoryOf;
template <class... X> struct HistoryOf<std::tuple<X...>> { using type = std::tuple<HeldHistory<X>...>; };
template <class C, class HeldTuple> struct TrajectoryOf;
template <class C, class... X> struct TrajectoryOf<C, std::tuple<X...>> {
  using type = CraftTrajectory<C, X...>;
  using failure = CraftFailure<C, X...>;
};

/// The places of those parts for which `wanted` has true, as an index_sequence.
template <bool... wanted> constexpr auto places() {
  constexpr std::size_t count = (std::size_t{0} + ... + wanted);
  constexpr auto found = [] {
    std::array<std::size_t, count + 1> places{};
    std::size_t number = 0, place = 0;
    ((places[number] = place++, number += wanted), ...);
    return places;
  }();
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::index_sequence<found[i]...>{};
  }
  (std::make_index_sequence<count>{});
}

template <std::size_t... i, class Function>
void for_parts(std::index_sequence<i...>, const Function& function) {
  (function.template operator()<i>(), ...);
}

/// What a run keeps of those parts that tick.
template <class... Parts> auto running(const std::tuple<Parts...>& parts, double start, double end) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::tuple<Running<std::tuple_element_t<i, std::tuple<Parts...>>>...>{
        Running<std::tuple_element_t<i, std::tuple<Parts...>>>(std::get<i>(parts), start, end)...};
  }
  (places<PartOf<Parts>::ticks...>());
}

/// The loads of a scenario, each with the held values, which outlive it.
template <class... Parts, class HeldTuple>
auto held_loads(const std::tuple<Parts...>& parts, const HeldTuple& values) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::tuple<HeldLoad<std::tuple_element_t<i, std::tuple<Parts...>>, HeldTuple>...>{
        {std::get<i>(parts), &values}...};
  }
  (places<PartOf<Parts>::load...>());
}

/// The rates of a craft under its loads.
template <CraftType C, class... Loads>
CraftRates<C, Loads...> rates_under(const C& craft, const std::tuple<Loads...>& loads) {
  return {craft, loads};
}
/// The held X with which a function sees the accelerations; void if it does not see them.
template <class C, class Arguments> struct SolvesWith { using type = void; };
template <class C, class X, class... Rest> struct SolvesWith<C, std::tuple<Solved<C, X>, Rest...>> {
  using type = X;
};

/// The values that a run holds, and their changes. Its loads, roots and changes refer to it.
template <CraftType C, class... Parts> class Flight {
  using HeldTuple = HeldTypes<Parts...>;
  template <std::size_t i> using Part = std::tuple_element_t<i, std::tuple<Parts...>>;
  using Runnings = decltype(running(std::declval<const std::tuple<Parts...>&>(), 0.0, 0.0));
  /// The number of part i among those that tick.
  template <std::size_t i>
  static constexpr std::size_t place_in_running = [] {
    constexpr std::array ticks{PartOf<Parts>::ticks...};
    return static_cast<std::size_t>(std::count(ticks.begin(), ticks.begin() + i, true));
  }();
  using Rates =
      decltype(rates_under(std::declval<const C&>(), held_loads(std::declval<const std::tuple<Parts...>&>(),
                                                                std::declval<const HeldTuple&>())));

 public:
  Flight(const CraftScenario<C, Parts...>& scenario, double start, double end)
      : core_(scenario.craft().core()),
        parts_(scenario.parts()),
        apart_(same_instant(start, end)),
        work_(core_->tree.work()),
        values_(initial(parts_)),
        running_(running(parts_, start, end)),
        rates_(rates_under(scenario.craft(), held_loads(parts_, values_))) {
    std::apply([&](const auto&... value) { (record(start, value), ...); }, values_);
  }
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;

  /// The derivative of the state under the loads, with the values that are held now.
  void rates(double t, const double* y, double* ydot) {
    solved_ = false;
    rates_(t, y, ydot);
  }
  /// The loads alone, as CraftRates::loads() gives them.
  const multibody::Work<double>& loads(double t, const double* y) {
    solved_ = false;
    return rates_.loads(t, y);
  }
  /// As CraftRates::not_finite(), with the values that are held now.
  std::string not_finite(double t, const double* y) {
    solved_ = false;
    return rates_.not_finite(t, y);
  }
  std::vector<double> breakpoints(double start, double end) const {
    const auto lists_of = [](const auto&... part) { return std::vector<const TickList*>{&part.list...}; };
    return instants_of(std::apply(lists_of, running_), start, end);
  }
  std::vector<ode::Root> roots() {
    std::vector<ode::Root> roots;
    for_parts(places<PartOf<Parts>::zero...>(),
              [&]<std::size_t i>() { roots.push_back(root(std::get<i>(parts_))); });
    return roots;
  }
  /// All changes that are due see the values from before.
  void change(double t, std::span<double> y, std::span<const ode::Event> ended_by) {
    if constexpr (!std::is_same_v<HeldTuple, std::tuple<>>) {
      const Now<C> now = now_at(t, y);
      HeldTuple next = values_;
      std::size_t root = 0;
      for_parts(places<(PartOf<Parts>::zero || PartOf<Parts>::ticks)...>(), [&]<std::size_t i>() {
        if constexpr (PartOf<Part<i>>::zero) cross(std::get<i>(parts_), root++, now, ended_by, next);
        if constexpr (PartOf<Part<i>>::ticks)
          tick(std::get<i>(parts_), std::get<place_in_running<i>>(running_), now, next);
      });
      values_ = std::move(next);
      solved_ = false;
      stop(t, y);
      settle(t, y);
    }
  }
  const HeldTuple& values() const { return values_; }
  /// What was held, taken out of here when the run has ended.
  typename HistoryOf<HeldTuple>::type take_history() { return std::move(history_); }

 private:
  static HeldTuple initial(const std::tuple<Parts...>& parts) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      return HeldTuple{std::get<i>(parts).initial...};
    }
    (places<PartOf<Parts>::held...>());
  }

  /// An instant is placed once for all functions that see it.
  Now<C> now_at(double t, std::span<const double> y) {
    if (!(t == t_ && std::equal(y.begin(), y.end(), y_.begin()))) {
      t_ = t;
      std::copy(y.begin(), y.end(), y_.begin());
      core_->tree.place(y_.data(), work_);
      solved_ = false;
    }
    return {trusted, *core_, t_, y_.data(), work_};
  }
  template <class X> Solved<C, X> solved_at(double t, std::span<const double> y) {
    return {now_at(t, y), [this](const X& x) { return solve_with(x); }};
  }
  template <class X> Accelerated<C> solve_with(const X& x) {
    X& value = std::get<X>(values_);
    const bool as_held = value == x;
    if (!(as_held && solved_)) {
      struct Restored {
        X& value;
        X held;
        ~Restored() { value = std::move(held); }
      } restored{value, std::exchange(value, x)};
      solved_ = false;
      rates_(t_, y_.data(), ydot_.data());
      solved_ = as_held;
    }
    return {{trusted, *core_, t_, y_.data(), rates_.work()}, ydot_};
  }
  /// If what is to stand still moves, an impulse stops all of that at once. What the loads lock keeps its
  /// speed in it, but friction is finite: what sticks is free.
  void stop(double t, std::span<double> y) {
    if constexpr ((stands<Parts> || ...)) {
      bool moves = false;
      const auto ask = [&]<class B, class X>(const Stands<B, X>&) {
        moves = moves || (std::get<X>(values_).locked && detail::is_moving<C, B>(y.data()));
      };
      std::apply([&](const auto&... part) { (for_stands(ask, part), ...); }, parts_);
      if (!moves) return;

      const HeldTuple held = values_;
      const auto loosen = [&]<class Part>(const Part& part) {
        if constexpr (stands_still<Part>) std::get<typename Part::held>(values_) = part.moving;
      };
      std::apply([&](const auto&... part) { (loosen(part), ...); }, parts_);
      const multibody::Work<double>& locked = loads(t, y.data());
      values_ = held;
      using multibody::InImpulse;
      auto links = multibody::keeping(locked.held), rotors = multibody::keeping(locked.held_rotors);
      const auto mark = [&]<class B, class X>(const Stands<B, X>&) {
        using Shape = typename C::shape;
        if (!std::get<X>(values_).locked) return;
        if constexpr (Shape::template has_rotor<B>) {
          rotors[Shape::template spin_at<B> - Shape::rotors_begin] = InImpulse::stops;
        } else {
          constexpr std::size_t end = Shape::template link_of<B>();
          for (std::size_t i = end - Shape::template Part<B>::counts.links; i < end; ++i)
            links[i] = InImpulse::stops;
        }
      };
      std::apply([&](const auto&... part) { (for_stands(mark, part), ...); }, parts_);
      multibody::stop(core_->tree, links, rotors, y.data());

      const auto fit = [&]<class Part>(const Part& part) {
        if constexpr (is_after_impulse<Part>) {
          auto value = found(part.update, now_at(t, y), values_);
          if (!(value == std::get<decltype(value)>(values_))) put(values_, t, std::move(value));
        }
      };
      std::apply([&](const auto&... part) { (fit(part), ...); }, parts_);
      solved_ = false;
    }
  }
  template <class Function, class Part> static void for_stands(const Function& function, const Part& part) {
    if constexpr (stands<Part>) function(part);
  }
  void settle(double t, std::span<double> y) {
    bool settled = true;
    const auto end = [&]<class Part>(const Part& part) {
      if constexpr (is_settling<Part>) {
        using X = typename UpdateOf<decltype(part.begins)>::result;
        X& value = std::get<X>(values_);
        if (value == X{} || !part.ends(now_at(t, y), value)) return;
        value = X{};
        record(t, value);
      }
    };
    const auto begin = [&]<class Part>(const Part& part) {
      if constexpr (is_settling<Part>) {
        using X = typename UpdateOf<decltype(part.begins)>::result;
        X& value = std::get<X>(values_);
        if (!(value == X{})) return;
        X next = part.begins(solved_at<X>(t, y));
        if (next == X{}) return;
        value = std::move(next);
        record(t, value);
        settled = solved_ = false;
      }
    };
    const auto stand_still = [&]<class Part>(const Part& part) {
      if constexpr (stands_still<Part>)
        if (std::get<typename Part::held>(values_) == typename Part::held{}) y[part.at] = 0.0;
    };
    std::apply([&](const auto&... part) { (end(part), ...); }, parts_);
    std::apply([&](const auto&... part) { (stand_still(part), ...); }, parts_);
    do {
      settled = true;
      std::apply([&](const auto&... part) { (begin(part), ...); }, parts_);
    } while (!settled);
  }
  template <class F>
  static typename UpdateOf<F>::result found(const F& update, const Now<C>& now, const HeldTuple& values) {
    if constexpr (is_becomes<F>)
      return update.value;
    else
      return with_held(std::type_identity<Taken<F>>{}, update, values, now);
  }
  template <class X> void put(HeldTuple& next, double t, X value) {
    record(t, value);
    std::get<X>(next) = std::move(value);
  }
  template <class X> void record(double t, const X& value) {
    auto& history = std::get<HeldHistory<X>>(history_);
    if (!history.empty() && history.back().time == t)
      history.back().value = value;
    else
      history.push_back({t, value});
  }
  /// Of several ticks of one list at one instant each sees what the one before gave. Those of a clock, which
  /// may have a latency, are at instants of their own.
  template <class Trigger, class F>
  void tick(const Change<Trigger, F>& change, Running<Change<Trigger, F>>& running, const Now<C>& now,
            HeldTuple& next) {
    using X = typename UpdateOf<F>::result;
    const double t = now.time().value();
    const auto due = [&](std::size_t tick, double latency) {
      const auto& times = running.list.times;
      return tick < times.size() && times[tick] + latency <= t + apart_;
    };
    for (HeldTuple seen = values_; due(running.sampled, 0.0); ++running.sampled) {
      running.waiting.push_back(found(change.update, now, seen));
      std::get<X>(seen) = running.waiting.back();
    }
    for (; due(running.applied, running.list.latency); ++running.applied) {
      put<X>(next, t, std::move(running.waiting.front()));
      running.waiting.erase(running.waiting.begin());
    }
  }
  template <class G, class F>
  void cross(const Change<Zero<G>, F>& change, std::size_t root, const Now<C>& now,
             std::span<const ode::Event> ended_by, HeldTuple& next) {
    if constexpr (!is_effect<F>) {
      const auto is_this = [&](const ode::Event& event) { return event.root == root; };
      if (std::any_of(ended_by.begin(), ended_by.end(), is_this))
        put(next, now.time().value(), found(change.update, now, values_));
    }
  }
  template <class G, class F> ode::Root root(const Change<Zero<G>, F>& change) {
    const auto value = [this, &g = change.trigger.function](double t, std::span<const double> y) -> double {
      const auto at = [&] {
        using X = typename SolvesWith<C, Arguments<G>>::type;
        if constexpr (std::is_void_v<X>)
          return now_at(t, y);
        else
          return solved_at<X>(t, y);
      };
      const auto found = with_held(std::type_identity<Taken<G>>{}, g, values_, at());
      if constexpr (std::is_convertible_v<decltype(found), double>)
        return found;
      else
        return found.value();
    };
    return {change.trigger.name, value, change.trigger.direction, std::is_same_v<F, Stop>, !is_effect<F>};
  }

  std::shared_ptr<const CraftCore> core_;
  std::tuple<Parts...> parts_;
  double apart_;
  multibody::Work<double> work_;
  HeldTuple values_;
  Runnings running_;
  Rates rates_;
  double t_ = std::numeric_limits<double>::quiet_NaN();  ///< the instant of work_, and of rates_ if solved_
  std::array<double, C::state_size> y_{}, ydot_{};
  bool solved_ = false;
  typename HistoryOf<HeldTuple>::type history_;
};

}  // namespace vectrix::detail

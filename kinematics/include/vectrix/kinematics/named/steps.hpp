#pragma once

#include <optional>
#include <vectrix/kinematics/named/attitude.hpp>
#include <vectrix/kinematics/steps/coning.hpp>
#include <vectrix/kinematics/steps/exponential_step.hpp>
#include <vectrix/kinematics/steps/group_runge_kutta.hpp>
#include <vectrix/kinematics/steps/magnus.hpp>

namespace vectrix {
namespace detail {

// The frame b before a step is named by a and b.
template <class A, class B> struct FramesIn<Before<A, B>> : std::type_identity<FrameList<A, B>> {};
template <class A, class B, char next>
struct Lettered<Before<A, B>, next> : std::type_identity<Before<Some<next>, Some<next + 1>>> {
  static constexpr char after = next + 2;
};

}  // namespace detail

// One step of an attitude between frames known at run time: the words of kinematics/steps/ for a DCM or a
// quaternion, with the same laws and errors.

/// The rotation of b relative to a in a step: Increment for frames known at run time.
using NamedIncrement = Named<detail::FormOf<Increment<Some<'a'>, Some<'b'>>>>;
/// int w_ab^b dt, the count of a gyro: AngleIncrement.
using NamedAngleIncrement = Named<AngleIncrement<Some<'a'>, Some<'b'>>>;
using NamedFirstOrderAttitude = Named<FirstOrderAttitude<Some<'a'>, Some<'b'>>>;

/// Claims that the vector is the integral of the rate of b relative to a, in the axes of b.
inline NamedAngleIncrement angle_increment(Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                           const NamedVector<si::angle>& alpha_b) {
  using namespace detail::letters;
  return typed_law<Law<Of<B>, RelativeTo<A>, Vector<B, si::angle>>>(
      "angle_increment", [](const auto&... x) { return angle_increment(x...); }, b, a, alpha_b);
}
inline NamedAngleIncrement sum(const NamedAngleIncrement& first, const NamedAngleIncrement& second) {
  using namespace detail::letters;
  return typed_law<Law<AngleIncrement<A, B>, AngleIncrement<A, B>>>(
      "sum", [](const auto& x, const auto& y) { return x + y; }, first, second);
}

// advance(R_a_from_b, theta), exponential_step(R_a_from_b, w_ab_b, dt), first_order_step(...)
template <detail::NamedRotation R> R advanced(const R& R_a_from_b, const NamedIncrement& theta) {
  using namespace detail::letters;
  return typed_law<Law<detail::FormOfNamed<R>, Increment<A, B>>>(
      "advance", [](const auto&... x) { return advance(x...); }, R_a_from_b, theta);
}
inline NamedIncrement turned_by(const NamedAngularVelocity& w_ab_b, const Quantity<si::time>& dt) {
  using namespace detail::letters;
  return typed_law<Law<AngularVelocity<A, B, In<B>>>>(
      "turned_by", [&](const auto& w) { return turned_by(w, dt); }, w_ab_b);
}
template <detail::NamedRotation R>
R exponential_stepped(const R& R_a_from_b, const NamedAngularVelocity& w_ab_b, const Quantity<si::time>& dt) {
  using namespace detail::letters;
  return typed_law<Law<detail::FormOfNamed<R>, AngularVelocity<A, B, In<B>>>>(
      "exponential_step", [&](const auto&... x) { return exponential_step(x..., dt); }, R_a_from_b, w_ab_b);
}
template <class R>
  requires(std::same_as<R, NamedDcm> || std::same_as<R, NamedFirstOrderAttitude>)
NamedFirstOrderAttitude first_order_stepped(const R& R_a_from_b, const NamedAngularVelocity& w_ab_b,
                                            const Quantity<si::time>& dt) {
  using namespace detail::letters;
  return typed_law<Law<detail::FormOfNamed<R>, AngularVelocity<A, B, In<B>>>>(
      "first_order_step", [&](const auto&... x) { return first_order_step(x..., dt); }, R_a_from_b, w_ab_b);
}
inline NearestNamedDcm nearest_dcm(const NamedFirstOrderAttitude& M_a_from_b) {
  return nearest_dcm(To(M_a_from_b.frames()[0]), From(M_a_from_b.frames()[1]), M_a_from_b.matrix());
}

// coning_corrected(...) of two or three counts, and coning_corrected_after(before, now), of equal durations
// or each with its own
namespace detail {

template <class X> struct CountOrTime : std::type_identity<X> {};
template <>
struct CountOrTime<NamedAngleIncrement> : std::type_identity<AngleIncrement<Some<'a'>, Some<'b'>>> {};
template <class... Parts>
concept NamedCounts = (std::same_as<Parts, NamedAngleIncrement> || ...) &&
                      ((std::same_as<Parts, NamedAngleIncrement> ||
                        std::same_as<Parts, Quantity<si::time>>)&&...);

}  // namespace detail
template <class... Parts>
  requires detail::NamedCounts<Parts...> NamedIncrement corrected_increment(const Parts&... parts) {
    return typed_law<Law<typename detail::CountOrTime<Parts>::type...>>(
        "coning_corrected", [](const auto&... x) { return coning_corrected(x...); }, parts...);
  }
template <class... Parts>
  requires detail::NamedCounts<Parts...> NamedIncrement increment_after(const Parts&... parts) {
    return typed_law<Law<typename detail::CountOrTime<Parts>::type...>>(
        "coning_corrected_after", [](const auto&... x) { return coning_corrected_after(x...); }, parts...);
  }

namespace detail {

template <class Rate, class... Given>
concept GivesNamedRate =
    std::same_as<std::invoke_result_t<const Rate&, const Given&...>, NamedAngularVelocity>;

/// w as w_ab^b of the rotation or rate that has a and b.
template <class Known>
auto lettered_rate(std::string_view word, const Known& ab, const NamedAngularVelocity& w) {
  using namespace letters;
  using Rate = AngularVelocity<A, B, In<B>>;
  using Frames = std::conditional_t<std::same_as<Known, NamedDcm>, Dcm<A, B>, Rate>;
  typed_law<Law<Frames, Rate>>(
      word, [](const auto&...) { return true; }, ab, w);
  return Rate{trusted, w.coordinates()};
}
/// rate(t, R_a_from_b) as a function of typed values.
template <class Rate> auto lettered_function(std::string_view word, const NamedDcm& start, const Rate& rate) {
  using namespace letters;
  return [word, &start, &rate](const Quantity<si::time>& t, const Dcm<A, B>& R_a_from_b) {
    const NamedDcm now{trusted, start.to(), start.from(), R_a_from_b.matrix()};
    return lettered_rate(word, start, rate(t, now));
  };
}

}  // namespace detail

// Steps by a rate that is a function: munthe_kaas_step<4 or 5>(rate, R_a_from_b, t, dt), with
// rate(t, R_a_from_b), commutator_free_step(...), and magnus_increment<2, 4 or 6>(rate, t, dt), with rate(t)
template <int Order, class Rate, std::same_as<NamedDcm> R>
  requires((Order == 4 || Order == 5) && detail::GivesNamedRate<Rate, Quantity<si::time>, R>)
NamedDcm munthe_kaas_step(const Rate& rate, const R& R_a_from_b, const Quantity<si::time>& t,
                          const Quantity<si::time>& dt) {
  constexpr const char* word = "munthe_kaas_step";
  const auto typed = detail::lettered_function(word, R_a_from_b, rate);
  return detail::of_one(
      word, [&](const auto& start) { return munthe_kaas_step<Order>(typed, start, t, dt); }, R_a_from_b);
}
template <class Rate, std::same_as<NamedDcm> R>
  requires detail::GivesNamedRate<Rate, Quantity<si::time>, R> NamedDcm commutator_free_step(
      const Rate& rate, const R& R_a_from_b, const Quantity<si::time>& t, const Quantity<si::time>& dt) {
    constexpr const char* word = "commutator_free_step";
    const auto typed = detail::lettered_function(word, R_a_from_b, rate);
    return detail::of_one(
        word, [&](const auto& start) { return commutator_free_step(typed, start, t, dt); }, R_a_from_b);
  }
template <int Order, detail::GivesNamedRate<Quantity<si::time>> RateOfTime>
  requires(Order == 2 || Order == 4 || Order == 6)
NamedIncrement magnus_increment(const RateOfTime& rate, const Quantity<si::time>& t,
                                const Quantity<si::time>& dt) {
  using namespace detail::letters;
  constexpr const char* word = "magnus_increment";
  std::optional<NamedAngularVelocity> first;  // says which frames are a and b
  const auto typed = [&](const Quantity<si::time>& now) {
    const NamedAngularVelocity w_ab_b = rate(now);
    if (!first) first = w_ab_b;
    return detail::lettered_rate(word, *first, w_ab_b);
  };
  const Increment<A, B> theta = magnus_increment<Order>(typed, t, dt);
  return typed_law<Law<AngularVelocity<A, B, In<B>>>>(
      word, [&](const auto&) { return theta; }, *first);
}

}  // namespace vectrix

#pragma once

#include <vectrix/kinematics/steps/increment.hpp>

namespace vectrix {

/// int w_ab^b dt over an interval, rad, component by component in the rotating axes of b: the count of an
/// integrating gyro. It is a rotation vector only if w keeps its direction; coning_corrected() turns counts
/// into an increment.
///     alpha over [t1, t2] + alpha over [t2, t3] = alpha over [t1, t3]
template <Frame A, Frame B, class S = double>
class AngleIncrement : public detail::RelativeVector<B, si::angle, S> {
 public:
  AngleIncrement() = delete;  // angle_increment(of<B>, relative_to<A>, alpha_b)
  using detail::RelativeVector<B, si::angle, S>::RelativeVector;
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<AngleIncrement<A, B, S>> = true;

/// Claims that the vector is the integral of the rate of b relative to a, in the axes of b.
template <Frame B, Frame A, class S>
detail::OfTwo<B, A, AngleIncrement<A, B, S>> angle_increment(Of<B>, RelativeTo<A>,
                                                             const Vector<B, si::angle, S>& alpha_b) {
  return AngleIncrement<A, B, S>{detail::trusted, alpha_b};
}
template <class OfFrame, class RelativeToFrame, class Given>
auto angle_increment(  // of<B>, relative_to<A>: two frames; an angle expressed in b
    const OfFrame&, const RelativeToFrame&, const Given&) -> Refused = delete;

// For adjoining intervals.
template <class A, class B, class S>
AngleIncrement<A, B, S> sum(const AngleIncrement<A, B, S>& first, const AngleIncrement<A, B, S>& second) {
  return AngleIncrement<A, B, S>{detail::trusted, first.coordinates() + second.coordinates()};
}

namespace detail {

template <class A, class B, class S> void require_positive_duration(const S& dt, const char* action) {
  require_duration<A, B>(dt, action);
  if (!all(dt > S(0))) {
    throw BadInput(std::string{action} + "(of " + frame_name<B>() + " relative to " + frame_name<A>() +
                   "): dt is " + text(dt) + " s; a count takes time");
  }
}

template <class A, class B, class S, class... Times>
void require_positive_durations(const char* action, const Times&... dt) {
  (require_positive_duration<A, B>(S(dt.value()), action), ...);
}
template <class A, class B, class S>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_ratio(const char* action, const S& h, const S& h_other) {
  throw BadInput(std::string{action} + "(of " + frame_name<B>() + " relative to " + frame_name<A>() +
                 "): counts over " + text(h) + " s and over " + text(h_other) +
                 " s; the ratio of their durations overflows");
}
/// Of thirds of a step: their correction is off by about as large a part of it.
inline constexpr double equal_thirds = 1e-3;

}  // namespace detail

// The increment of a step from the angle increments of its parts: of equal duration, or each with its own.
template <class A, class B, class S>
Increment<A, B, S> corrected_increment(const AngleIncrement<A, B, S>& first,
                                       const AngleIncrement<A, B, S>& second) {
  const auto& a1 = first.coordinates();
  const auto& a2 = second.coordinates();
  return {detail::trusted, a1 + a2 + S(2) / S(3) * a1.cross(a2)};
}
template <class A, class B, class S>
Increment<A, B, S> corrected_increment(const AngleIncrement<A, B, S>& first, const Quantity<si::time, S>& dt1,
                                       const AngleIncrement<A, B, S>& second,
                                       const Quantity<si::time, S>& dt2) {
  detail::require_positive_durations<A, B, S>("coning_corrected", dt1, dt2);
  const S share = dt2.value() / dt1.value();  // so that no square underflows
  const S c = (S(2) + share + S(1) / share) / S(6);
  if (!detail::all(c - c == S(0)))
    detail::refuse_ratio<A, B, S>("coning_corrected", dt1.value(), dt2.value());
  const auto& a1 = first.coordinates();
  const auto& a2 = second.coordinates();
  return {detail::trusted, a1 + a2 + c * a1.cross(a2)};
}
template <class A, class B, class S>
Increment<A, B, S> corrected_increment(const AngleIncrement<A, B, S>& first,
                                       const AngleIncrement<A, B, S>& second,
                                       const AngleIncrement<A, B, S>& third) {
  const auto& a1 = first.coordinates();
  const auto& a2 = second.coordinates();
  const auto& a3 = third.coordinates();
  return {detail::trusted,
          a1 + a2 + a3 + S(9) / S(20) * a1.cross(a3) + S(27) / S(40) * a2.cross(detail::Column<S>(a3 - a1))};
}
template <class A, class B, class S>
Increment<A, B, S> corrected_increment(const AngleIncrement<A, B, S>& first, const Quantity<si::time, S>& dt1,
                                       const AngleIncrement<A, B, S>& second,
                                       const Quantity<si::time, S>& dt2, const AngleIncrement<A, B, S>& third,
                                       const Quantity<si::time, S>& dt3) {
  detail::require_positive_durations<A, B, S>("coning_corrected", dt1, dt2, dt3);
  using std::abs;
  for (const S& dt : {dt2.value(), dt3.value()})
    if (!detail::all(abs(dt - dt1.value()) <= detail::number<S>(detail::equal_thirds) * dt1.value()))
      throw BadInput("coning_corrected(of " + frame_name<B>() + " relative to " + frame_name<A>() +
                     "): of three counts one takes " + detail::text(dt) + " s, the first " +
                     detail::text(dt1.value()) + " s; its coefficients are those of equal thirds");
  return corrected_increment(first, second, third);
}

namespace detail {

template <class... Parts> using CorrectedOf = decltype(corrected_increment(std::declval<const Parts&>()...));
template <class... Parts>
concept Corrects = requires {
  typename CorrectedOf<Parts...>;
};

}  // namespace detail

/// The increment of a step from the counts of its two or three parts, each with its duration:
/// coning_corrected(alpha1, dt1, alpha2, dt2). Without durations it is a claim that they are equal.
///     theta = alpha1 + alpha2 + c alpha1 x alpha2,  c = (h1 + h2)^2 / (6 h1 h2), 2/3 for equal ones
///     theta = alpha1 + alpha2 + alpha3 + 9/20 alpha1 x alpha3 + 27/40 alpha2 x (alpha3 - alpha1)
/// The first is exact to second order for a linear rate; equal parts have order 4 for a polynomial rate, and
/// it is then the best two-sample rule in coning (Ignagni 1990). The second has the coefficients with the
/// smallest drift in coning (Miller 1983). Throws BadInput unless the durations are positive, two have a
/// finite ratio, and three are equal.
template <class... Parts> detail::CorrectedOf<Parts...> coning_corrected(const Parts&... alpha) {
  return corrected_increment(alpha...);
}
template <class... Parts>
  requires(!detail::Corrects<Parts...>)
auto coning_corrected(  // two or three angle increments of one b relative to one a, each with its dt or equal
    const Parts&...) -> Refused = delete;

// The increment of an interval from its angle increment and the one before; equal intervals, or each with its
// duration.
template <class A, class B, class S>
Increment<A, B, S> increment_after(const AngleIncrement<A, B, S>& alpha_before,
                                   const AngleIncrement<A, B, S>& alpha) {
  return {detail::trusted,
          alpha.coordinates() + alpha_before.coordinates().cross(alpha.coordinates()) / S(12)};
}
template <class A, class B, class S>
Increment<A, B, S> increment_after(const AngleIncrement<A, B, S>& alpha_before,
                                   const Quantity<si::time, S>& dt_before,
                                   const AngleIncrement<A, B, S>& alpha, const Quantity<si::time, S>& dt) {
  detail::require_positive_durations<A, B, S>("coning_corrected_after", dt_before, dt);
  const S share = dt.value() / dt_before.value();  // so that no square underflows or overflows
  const S c = share * (share / (S(1) + share)) * (S(1) / S(6));
  if (!detail::all(c - c == S(0)))
    detail::refuse_ratio<A, B, S>("coning_corrected_after", dt_before.value(), dt.value());
  return {detail::trusted, alpha.coordinates() + c * alpha_before.coordinates().cross(alpha.coordinates())};
}

namespace detail {

template <class... Parts> using AfterOf = decltype(increment_after(std::declval<const Parts&>()...));
template <class... Parts>
concept CorrectsAfter = requires {
  typename AfterOf<Parts...>;
};

}  // namespace detail

/// The increment over the interval h of one count, corrected with the previous count, over h_before:
/// coning_corrected_after(alpha_before, dt_before, alpha, dt). For a rate that is linear over both:
///     theta = alpha + c alpha_before x alpha,  c = h^2 / (6 h_before (h_before + h))
/// For equal intervals c = 1/12 (Savage 1998): coning_corrected_after(alpha_before, alpha). In coning it is
/// as good as the two-sample rule, and gives an increment at every count. For a general motion the error of
/// an interval is h^4/12 w x w'' and the order is 3; the two-sample rule has order 4. Throws BadInput unless
/// the durations are positive, with a finite ratio.
template <class... Parts> detail::AfterOf<Parts...> coning_corrected_after(const Parts&... parts) {
  return increment_after(parts...);
}
template <class... Parts>
  requires(!detail::CorrectsAfter<Parts...>)
auto coning_corrected_after(  // angle increments of one b relative to one a: two, or each with its dt
    const Parts&...) -> Refused = delete;

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const AngleIncrement<A, B, S>& alpha) {
  return detail::print_column(out, alpha.coordinates(), "rad")
         << detail::print_of_relative_to<B, A> << " in " << frame_name<B>();
}

}  // namespace vectrix

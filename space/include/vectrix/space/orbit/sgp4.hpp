#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <vectrix/kinematics/points/acceleration.hpp>
#include <vectrix/kinematics/points/derivative.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>
#include <vectrix/kinematics/points/parallel.hpp>
#include <vectrix/space/earth/teme.hpp>
#include <vectrix/space/orbit/mean_elements.hpp>
#include <vectrix/space/orbit/orbit_mean_elements_message.hpp>
#include <vectrix/space/orbit/two_body.hpp>
#include <vectrix/space/orbit/two_line_elements.hpp>

namespace vectrix {

/// The position of q relative to p, observed from a, and its derivatives up to the third.
template <Point P, Point Q, Frame A> struct PointPath {
  PointMotion<P, Q, A> motion;
  Acceleration<P, Q, ObservedFrom<A>, In<A>> acceleration;
  Derivative<A, A, si::acceleration> jerk;
};

/// The longest time before or after the epoch of the elements for which a propagation answers:
///     at_most(72.0 * si::hour)
struct AtMost {
  Quantity<si::time> age;
};
template <class U>
constexpr std::enable_if_t<detail::converts<si::time, U, double>, AtMost> at_most(const Quantity<U>& age) {
  return {convert<si::time>(age)};
}
template <class Given>
auto at_most(  // a time, the longest age of elements: at_most(72.0 * si::hour)
    const Given&) -> Refused = delete;

namespace detail {

struct Sgp4Theory;

/// The numbers of an Sgp4. They never change.
class VECTRIX_EXPORT Sgp4Model {
 public:
  /// `name` starts the message of every BadInput.
  Sgp4Model(std::string name, const MeanElements& elements, const AtMost& longest);

  [[nodiscard]] const MeanElements& elements() const { return elements_; }
  [[nodiscard]] const Quantity<si::time>& longest_age() const { return longest_age_; }
  [[nodiscard]] OrbitNumbers at(const Epoch& epoch) const;
  /// Of the position by time: 0 to 2, or 0 to 3.
  template <std::size_t order>
  [[nodiscard]] std::array<Eigen::Vector3d, order + 1> derivatives(const Epoch& epoch) const;

 private:
  /// Throws BadInput if the elements are too old.
  [[nodiscard]] double minutes_to(const Epoch& epoch) const;

  std::string name_;
  MeanElements elements_;
  Quantity<si::time> longest_age_;
  std::shared_ptr<const Sgp4Theory> theory_;  // shared by copies
};

}  // namespace detail

/// The motion of q by the theory of the two-line elements, SGP4 near the Earth and SDP4 for periods from 225
/// minutes: Spacetrack Report No. 3, corrected as in Vallado, Crawford, Hujsak and Kelso, AIAA 2006-6753, in
/// the mode "improved", not "afspc", constants of WGS-72. Time is SI
/// seconds since the epoch of the elements. The theory is good to about a km at the epoch and loses 1 to 3 km
/// a day, so the longest age is a mandatory word:
///     const Sgp4<Satellite> orbit(TwoLineElements::parse(line1, line2), at_most(72.0 * si::hour));
/// A call depends on its epoch alone, whatever was asked before, and threads may share an object. Throws
/// BadInput for elements out of range, also a mean motion of an orbit inside the Earth or farther than 1.5
/// million km, and an age that is not positive and finite.
template <Point Q> class Sgp4 {
 public:
  Sgp4(const MeanElements& elements, const AtMost& longest) : model_(name(), elements, longest) {}
  Sgp4(const TwoLineElements& set, const AtMost& longest)
      : model_(name() + "catalogue number " + detail::text(set.catalogue_number()) + ", ",
               set.mean_elements(), longest) {}
  Sgp4(const OrbitMeanElementsMessage& message, const AtMost& longest)
      : model_(name() + message.object_name() + " " + message.object_id() + ", ", message.mean_elements(),
               longest) {}
  template <class... Given>
  Sgp4(  // mean elements, two lines or a message, and the longest age: Sgp4<Q>(set, at_most(72.0 * si::hour))
      const Given&...) = delete;

  [[nodiscard]] const MeanElements& elements() const { return model_.elements(); }
  [[nodiscard]] const Quantity<si::time>& longest_age() const { return model_.longest_age(); }

  /// Position and velocity relative to the centre of the Earth, as published. The velocity is that of the
  /// theory, which leaves out small terms: it is not quite the derivative of the position, 0.02 m/s off in a
  /// low orbit, up to 20 m/s in an eccentric one with a resonance, and more with much drag or e near 1.
  /// Throws BadInput if the epoch is farther from that of the elements than the longest age, or the theory
  /// ends before it: the eccentricity leaves [0, 1), or the body is below one Earth radius, decayed.
  [[nodiscard]] PointMotion<earth::Teme, Q, earth::Teme> at(const Epoch& epoch) const {
    return detail::point_motion_of<earth::Teme, Q, earth::Teme>(model_.at(epoch));
  }
  /// The same position with its own derivatives, exact, for frames with rates:
  ///     lvlh(from<L>, now.motion, now.acceleration, now.jerk)
  /// Throws BadInput as at() does, and for an orbit so deep through the Earth that J2 (R/p)^2 is above 0.01.
  [[nodiscard]] PointPath<earth::Teme, Q, earth::Teme> path(const Epoch& epoch) const {
    using earth::Teme;
    const auto [r, v, a, jerk] = model_.template derivatives<3>(epoch);
    return {detail::point_motion_of<Teme, Q, Teme>({r, v}),
            Acceleration<Teme, Q, ObservedFrom<Teme>, In<Teme>>{detail::trusted, a},
            Derivative<Teme, Teme, si::acceleration>{detail::trusted,
                                                     Vector<Teme, si::jerk>{detail::trusted, jerk}}};
  }
  /// path() as an edge, which needs no jerk.
  [[nodiscard]] AcceleratingTransform<earth::Teme, Q> transform(detail::Trusted, const Epoch& epoch) const {
    using earth::Teme;
    const auto [r, v, a] = model_.template derivatives<2>(epoch);
    return parallel(detail::point_motion_of<Teme, Q, Teme>({r, v}),
                    Acceleration<Teme, Q, ObservedFrom<Teme>, In<Teme>>{detail::trusted, a});
  }
  /// at() with axes parallel to those of Teme: an edge of a frame graph, edge(orbit).
  MovingTransform<earth::Teme, Q> operator()(const Epoch& epoch) const { return parallel(at(epoch)); }

 private:
  static std::string name() { return "Sgp4(" + frame_name<Q>() + "): "; }

  detail::Sgp4Model model_;
};

/// path() as an edge of a frame graph, edge(path(orbit)): with the acceleration.
template <class Q> auto path(const Sgp4<Q>& orbit) {
  return [orbit](const Epoch& epoch) { return orbit.transform(detail::trusted, epoch); };
}

}  // namespace vectrix

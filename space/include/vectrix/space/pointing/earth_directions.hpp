#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/caller.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/pointing/moving_direction.hpp>

namespace vectrix {
namespace detail {

/// Three columns in, three out; those of derivatives that are not known are not used.
using PathInItrf = Jet<double, 3>;
VECTRIX_EXPORT PathInItrf geodetic_up(const Caller& name, const PathInItrf& path);
VECTRIX_EXPORT PathInItrf limb_of_ellipsoid(const Caller& name, double height, const PathInItrf& path,
                                            const PathInItrf& towards);

template <std::size_t N> PathInItrf with_zeros(const Jet<double, N>& jet) {
  PathInItrf all{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (std::size_t i = 0; i < N; ++i) all[i] = jet[i];
  return all;
}

/// The motion of q relative to the origin of ITRF, observed from it.
template <class First, class... Others> inline constexpr bool moves_in_itrf = false;
template <class Q, class... Others>
inline constexpr bool moves_in_itrf<Displacement<earth::Itrf, Q, In<earth::Itrf>>, Others...> = true;
template <class Q, class... Others>
inline constexpr bool moves_in_itrf<PointMotion<earth::Itrf, Q, earth::Itrf>, Others...> = true;

template <class... Motion>
  requires moves_in_itrf<Motion...>
using InItrf = PointedOf<Motion...>;
template <class... Motion>
concept HasPlaceInItrf = requires {
  typename InItrf<Motion...>;
};

template <Level level, class... Motion>
auto limb_seen(const Quantity<si::length>& height, const MovingDirection<earth::Itrf, level>& u_itrf,
               const Motion&... motion)
    -> MovingDirection<earth::Itrf, std::min(level, InItrf<Motion...>::level)> {
  const auto limb =
      limb_of_ellipsoid({"wgs84::limb"}, height.value(), with_zeros(moving_direction(motion...).numbers()),
                        with_zeros(u_itrf.numbers()));
  return {trusted, leading<std::min(level, InItrf<Motion...>::level)>(limb)};
}
template <class... Given> using LimbOf = decltype(limb_seen(std::declval<const Given&>()...));
template <class... Given>
concept HasLimb = requires {
  typename LimbOf<Given...>;
};

}  // namespace detail

namespace wgs84 {

/// The normal of the ellipsoid below a point q, upwards, with its derivatives as q moves: the opposite of the
/// geodetic nadir. From r, or r and v, or r, v and a of q, as moving_direction() takes them, relative to
/// earth::Itrf. With n the normal, h the height, D = diag(a^2, a^2, b^2) and s = sqrt(n . D n)
///     r = D n/s + h n,      (D/s - D n n^T D/s^3 + h I) ndot = v - (n . v) n
/// It is off r by up to 0.19 deg. Throws BadInput for the centre of the Earth, and within 1 m of the evolute,
/// which is within 43 km of it.
template <class... Motion> detail::InItrf<Motion...> moving_up(const Motion&... motion) {
  const auto path = moving_direction(motion...);
  const auto up = detail::geodetic_up({"wgs84::moving_up"}, detail::with_zeros(path.numbers()));
  return {detail::trusted, detail::leading<decltype(path)::level>(up)};
}
template <class... Motion>
  requires(!detail::HasPlaceInItrf<Motion...>)
auto moving_up(  // r, v, a of a point relative to earth::Itrf, observed from it, in it
    const Motion&...) -> Refused = delete;

/// The direction from q to the limb on the side of another direction u: to the point where a ray in the plane
/// of r and u touches the ellipsoid with the semi-axes of WGS-84, each longer by the height; that is the
/// surface at this height, to 0.2 m up to 100 km. The map x -> (x/a, x/a, z/b) makes it a unit sphere, in
/// which the direction is along
///     n x r - sqrt((|r|^2 - 1) |n|^2) r,      n = r x u
/// The lower level of the two decides what is known:
///     wgs84::limb(height, u_itrf, r)     (height, u_itrf, r, v)     (height, u_itrf, r, v, a)
/// Throws BadInput if the height is not finite, q is not above it, or u is along r to nearly_one_direction.
template <class... Given> detail::LimbOf<Given...> limb(const Given&... given) {
  return detail::limb_seen(given...);
}
template <class... Given>
  requires(!detail::HasLimb<Given...>)
auto limb(  // the height, a MovingDirection in earth::Itrf; then r, v, a of a point relative to it, in it
    const Given&...) -> Refused = delete;

}  // namespace wgs84
}  // namespace vectrix

#pragma once

#include <Eigen/Core>
#include <concepts>
#include <type_traits>

#include <vectrix/frames/displacement.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/space/earth/position_in_itrf.hpp>
#include <vectrix/space/sky/bodies.hpp>

namespace vectrix {
namespace detail {

template <class Given>
inline constexpr bool is_place = std::convertible_to<const Given&, earth::PositionInItrf>;
template <class Given> inline constexpr bool is_towards_sun = false;
template <class U> inline constexpr bool is_towards_sun<Vector<earth::Itrf, U>> = true;
template <class P, class S>
inline constexpr bool is_towards_sun<Displacement<P, S, In<earth::Itrf>>> = is_sun<S>;

}  // namespace detail

/// The density of the atmosphere by Harris and Priester, for a mean activity of the Sun (Montenbruck and
/// Gill, Satellite Orbits, section 3.5.2, table 3.8), from 100 to 1000 km above the ellipsoid WGS-84:
///     rho = rho_min(h) + (rho_max(h) - rho_min(h)) cos^n(psi/2)
/// psi the angle between the position and the apex of the bulge, 30 deg east of the Sun; rho_min and rho_max
/// of a table, exponential between its heights. Over the cycle of the Sun's activity the density changes by a
/// factor of more than ten at 500 km, which is not in it.
class VECTRIX_EXPORT HarrisPriester {
 public:
  /// The exponent n says how far the bulge reaches to the poles: from 2 for orbits of a low inclination to 6
  /// for polar orbits. Throws BadInput outside 2 to 6.
  explicit HarrisPriester(double exponent);
  HarrisPriester() = delete;  // HarrisPriester(exponent): 2 for low inclinations to 6 for polar orbits

  /// At a position, with the direction to the Sun, or to its image, of any length; both along the axes of
  /// earth::Itrf. The Sun seen from the position serves as well as from the centre of the Earth. Throws
  /// BadInput if the height is outside 100 to 1000 km, or the direction is zero.
  template <class Place, class Sun>
  [[nodiscard]] std::enable_if_t<detail::is_place<Place> && detail::is_towards_sun<Sun>,
                                 Quantity<si::density>>
  density(const Place& r_itrf, const Sun& to_the_sun) const {
    return under_the_sun(
        r_itrf, detail::direction_for("HarrisPriester::density", detail::plain(to_the_sun)).coordinates());
  }
  template <class... Given>
  auto density(  // (r_itrf, to_the_sun): a position in m and the Sun, both in earth::Itrf
      const Given&...) const -> Refused = delete;

 private:
  [[nodiscard]] Quantity<si::density> under_the_sun(const earth::PositionInItrf& r_itrf,
                                                    const Eigen::Vector3d& to_the_sun) const;

  double exponent_;
};

}  // namespace vectrix

#pragma once

#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/earth/position_in_itrf.hpp>

namespace vectrix {

/// The density of the atmosphere by the height h above the ellipsoid WGS-84 alone:
///     rho = rho0 exp(-(h - h0)/H)
/// in one layer or in several. Drag in a low orbit is wrong by a factor of two or more, because the true
/// density follows the Sun's activity and the time of the day: see HarrisPriester.
class VECTRIX_EXPORT ExponentialAtmosphere {
 public:
  struct Layer {
    Quantity<si::density> density;            // rho0, at the base
    Quantity<si::length> base, scale_height;  // h0, H
  };

  /// The 28 layers of Vallado (Fundamentals of Astrodynamics and Applications, table 8-4), from 0 km: the US
  /// Standard Atmosphere of 1976, then CIRA-72 with an exospheric temperature of 1000 K. The last layer, from
  /// 1000 km, has no end. From one layer to the next rho jumps by up to 0.4 %.
  static ExponentialAtmosphere vallado();
  /// One layer, for all heights from 0 on. Throws BadInput if rho0 or H is not positive, or a number is not
  /// finite.
  explicit ExponentialAtmosphere(const Layer& layer);

  /// At a height, or at a position. Throws BadInput if the height is negative or not finite.
  [[nodiscard]] Quantity<si::density> density(const Quantity<si::length>& height) const;
  [[nodiscard]] Quantity<si::density> density(const Vector<earth::Itrf, si::length>& r_itrf) const;
  template <class E, class Q>
    requires detail::is_earth<E>
  [[nodiscard]] Quantity<si::density> density(const Displacement<E, Q, In<earth::Itrf>>& r_eq) const {
    return density(r_eq.vector());
  }
  template <class Given>
    requires(!detail::is_quantity<Given>)
  auto density(  // of a height in m, or a position in m along the axes of earth::Itrf
      const Given&) const -> Refused = delete;

 private:
  explicit ExponentialAtmosphere(std::vector<Layer> layers);

  std::vector<Layer> layers_;  // upwards
};

}  // namespace vectrix

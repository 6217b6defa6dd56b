#pragma once

#include <memory>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/points/derivative.hpp>
#include <vectrix/space/earth/position_in_itrf.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix {

/// The main magnetic field of the Earth, of its core, in axes fixed in it:
///     V = a sum_nm (a/r)^(n+1) P_nm(sin phi) (g_nm cos m lambda + h_nm sin m lambda),    B = -grad V
/// with functions normalized by Schmidt, a = 6371.2 km, and coefficients linear in time between the years of
/// the model. A position and a field in axes fixed in the Earth leave no choice between geodetic and
/// geocentric axes, which differ by up to 109 nT. Immutable, and cheap to copy; threads may share it.
class VECTRIX_EXPORT MagneticField {
 public:
  /// The International Geomagnetic Reference Field, 14th generation (IAGA 2024), 1900.0 to 2030.0.
  static MagneticField igrf14();
  /// The World Magnetic Model 2025 (NOAA/NCEI and BGS), 2025.0 to 2030.0.
  static MagneticField wmm2025();

  /// The times between which the model holds. Years begin at midnight of 1 January in Terrestrial Time; the
  /// minute to UTC is 2e-4 nT.
  [[nodiscard]] const Epoch& first() const;
  [[nodiscard]] const Epoch& last() const;

  /// B at a point and an instant. Throws BadInput outside the times of the model, and if the point is less
  /// than 6200 km from the centre: inside the Earth the series does not hold.
  [[nodiscard]] Vector<earth::Itrf, si::magnetic_flux_density> at(const earth::PositionInItrf& r_itrf,
                                                                  const Epoch& epoch) const;

  struct WithRate {
    Vector<earth::Itrf, si::magnetic_flux_density> field;
    Derivative<earth::Itrf, earth::Itrf, si::magnetic_flux_density> rate;  ///< T/s
  };
  /// The same with its secular variation, dB/dt at a point fixed to the Earth: constant between the years of
  /// the model, where it jumps to that of the years after.
  [[nodiscard]] WithRate with_rate(const earth::PositionInItrf& r_itrf, const Epoch& epoch) const;

 private:
  struct Series;
  explicit MagneticField(std::shared_ptr<const Series> series) : series_(std::move(series)) {}

  std::shared_ptr<const Series> series_;
};

}  // namespace vectrix

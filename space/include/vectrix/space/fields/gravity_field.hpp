#pragma once

#include <filesystem>
#include <memory>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/earth/position_in_itrf.hpp>
#include <vectrix/space/fields/gravity_gradient.hpp>

namespace vectrix {

/// The gravitation of the Earth in axes fixed in it, without the centrifugal acceleration:
///     V = mu/r sum_nm (a/r)^n P_nm(sin phi) (C_nm cos m lambda + S_nm sin m lambda),    g = grad V
/// Outside the Earth at every point, the poles included. Immutable, and cheap to copy; threads may share it.
class VECTRIX_EXPORT GravityField {
 public:
  /// EGM2008 (Pavlis, Holmes, Kenyon, Factor 2012), tide-free, up to the given degree: 20 at most. Higher
  /// degrees: read(). Throws BadInput for a degree outside 0 to 20.
  static GravityField egm2008(int degree = 20);
  /// From a file in the format of the International Centre for Global Earth Models (*.gfc), up to the given
  /// degree. Throws BadInput with file, line and reason if it is not the gravity field of a fully normalized
  /// model of the Earth, in m^3/s^2 and m, depends on time, ends at a lower degree, lacks a coefficient or a
  /// word of its head, or has one twice; if C20 is not from -4.85e-4 to -4.83e-4, as where it has the other
  /// sign or is not normalized, or a coefficient of degree 1 is above 1e-8: 0.1 m from the centre of mass.
  static GravityField read(const std::filesystem::path& gfc, int degree);

  [[nodiscard]] int degree() const;
  /// mu = G M, and the radius a.
  [[nodiscard]] Quantity<si::gravitational_parameter> mu() const;
  [[nodiscard]] Quantity<si::length> radius() const;

  /// g at a point, m/s^2. Throws BadInput if the point is less than 0.98 a from the centre: inside the Earth
  /// the series does not hold.
  [[nodiscard]] Vector<earth::Itrf, si::acceleration> acceleration(const earth::PositionInItrf& r_itrf) const;

  struct WithGradient {
    Vector<earth::Itrf, si::acceleration> acceleration;
    GravityGradient<earth::Itrf> gradient;
  };
  /// The same with its gradient, for less than the cost of two.
  [[nodiscard]] WithGradient with_gradient(const earth::PositionInItrf& r_itrf) const;

 private:
  struct Series;
  explicit GravityField(std::shared_ptr<const Series> series) : series_(std::move(series)) {}

  std::shared_ptr<const Series> series_;
};

}  // namespace vectrix

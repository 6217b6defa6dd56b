#pragma once

#include <string>

#include <vectrix/space/sky/chebyshev.hpp>
#include <vectrix/space/time/time_span.hpp>

namespace vectrix::detail {

/// The numbers of an Ephemeris, in m and m/s along the axes of GCRF, relative to the centre of the Earth. The
/// observer's position and velocity are r and v. All throw BadInput for an epoch outside the span.
class VECTRIX_EXPORT EphemerisTable {
 public:
  EphemerisTable(Body body, const TimeSpan& span);
  /// With another name in errors than Ephemeris<...>.
  EphemerisTable(std::string name, Body body, const TimeSpan& span);

  [[nodiscard]] const TimeSpan& span() const { return span_; }
  [[nodiscard]] PlainMotion motion(const Epoch& epoch) const;
  /// Of the centre of the Earth relative to the barycentre of the solar system.
  [[nodiscard]] PlainMotion earth(const Epoch& epoch) const;

  // The body from the observer. With light time: r_body(t - |d|/c) - r_observer(t), both relative to the
  // barycentre of the solar system.
  [[nodiscard]] Eigen::Vector3d line(Geometric, const Epoch& epoch, const Eigen::Vector3d& r) const;
  [[nodiscard]] Eigen::Vector3d line(LightTime, const Epoch& epoch, const Eigen::Vector3d& r) const;
  [[nodiscard]] Eigen::Vector3d line(Apparent, const Epoch& epoch, const Eigen::Vector3d& r,
                                     const Eigen::Vector3d& v) const;

 private:
  [[nodiscard]] Eigen::Vector3d line(const Epoch& epoch, const Eigen::Vector3d& r,
                                     const PlainMotion& earth_now) const;
  void require(const Epoch& epoch) const;

  std::string name_;
  Body body_;
  TimeSpan span_;
  ChebyshevPieces body_pieces_, earth_pieces_;
};

}  // namespace vectrix::detail

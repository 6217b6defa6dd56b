#pragma once

#include <memory>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/points/coincident.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/earth/teme.hpp>

namespace vectrix {

/// The rotation of the Earth over a span of time, for loops:
///     const EarthMotion earth(orientation, span);    or    earth(orientation, span, subdaily_tides)
///     graph edges   edge(earth), and to Teme, edge(teme(earth))
/// It is orientation.at(t) to 1 microarcsec, 0.03 mm, in some 0.1 microseconds, and has the angular
/// acceleration. Polynomials of degree 5 over each day of X, Y, the angle ERA - s + s', x and y agree at
/// midnight TAI with eraXy06 and the spline of the rows, in value and both derivatives; w and alpha are exact
/// derivatives of these. With the tides they are over a sixteenth of a day. Building takes 0.3 ms a day, and
/// 300 bytes, with tides 5 kB. It never changes, so threads may share it; copies are cheap. Throws BadInput
/// for a span outside the rows, and for an epoch outside the span.
class VECTRIX_EXPORT EarthMotion {
 public:
  EarthMotion(const EarthOrientation& orientation, const TimeSpan& span);
  EarthMotion(const EarthOrientation& orientation, const TimeSpan& span, SubdailyTides);
  template <class First, class... Given>
    requires(sizeof...(Given) > 0)
  EarthMotion(  // an EarthOrientation, a TimeSpan, and subdaily_tides by choice
      const First&, const Given&...)
  = delete;

  [[nodiscard]] const TimeSpan& span() const { return span_; }

  /// R_itrf^gcrf, w_gi^i and alpha_gi^i.
  [[nodiscard]] AcceleratingDcm<earth::Gcrf, earth::Itrf> at(const Epoch& epoch) const;
  /// The same with one origin: an edge of a frame graph.
  AcceleratingTransform<earth::Gcrf, earth::Itrf> operator()(const Epoch& epoch) const {
    return coincident(at(epoch));
  }
  /// R_itrf^gcrf alone, which takes less time.
  [[nodiscard]] Dcm<earth::Gcrf, earth::Itrf> rotation(const Epoch& epoch) const;

 private:
  EarthMotion(const EarthOrientation& orientation, const TimeSpan& span, bool with_tides);

  struct Place {
    const double* cell;
    double time;  // in cells
  };
  [[nodiscard]] inline Place place(const Epoch& epoch) const;

  TimeSpan span_;
  double first_day_;  // TAI
  int cells_of_a_day_;
  // Of each X, Y, the angle, x, y and the angle from TEME: their coefficients, degree by degree. Shared by
  // copies.
  std::shared_ptr<const std::vector<double>> cells_;

  friend VECTRIX_EXPORT AcceleratingDcm<earth::Teme, earth::Itrf> teme_from_itrf(const Epoch&,
                                                                                 const EarthMotion&);
};

/// The rotation of the Earth in TEME over the same span: teme_from_itrf(epoch, orientation.parameters(epoch))
/// to 1 microarcsec, in some 0.1 microseconds, and with the angular acceleration. Throws BadInput for an
/// epoch outside the span.
VECTRIX_EXPORT AcceleratingDcm<earth::Teme, earth::Itrf> teme_from_itrf(const Epoch& epoch,
                                                                        const EarthMotion& earth);

/// The rotation of the Earth in TEME as an edge of a frame graph, edge(teme(earth)).
inline auto teme(const EarthMotion& earth) {
  return [earth](const Epoch& epoch) { return coincident(teme_from_itrf(epoch, earth)); };
}

}  // namespace vectrix

#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/points/coincident.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/space/time/time_span.hpp>

namespace vectrix {

/// The frames of the Earth. They have their own namespace, so that users can use the short names.
namespace earth {

/// Geocentric Celestial Reference Frame: its axes do not rotate relative to distant objects.
struct Gcrf : inertial_frame {};
/// International Terrestrial Reference Frame: fixed to the Earth; z to the pole, x to the prime meridian.
struct Itrf : moving_frame {};
/// True equator and equinox of date: z along the celestial intermediate pole, x to the equinox.
struct TrueOfDate : moving_frame {};
/// Celestial Intermediate Reference Frame: z along the celestial intermediate pole, x to the celestial
/// intermediate origin, so that it does not turn about its z axis.
struct Cirf : moving_frame {};
/// Terrestrial Intermediate Reference Frame: z along the same pole, x to the terrestrial intermediate origin:
/// Itrf without polar motion.
struct Tirf : moving_frame {};

}  // namespace earth

/// The word that adds the variations of x, y and UT1 with periods of a day and half a day, which the IERS
/// series omits: the 71 ocean tides of the IERS Conventions 2010, section 8.2, at most 1 milliarcsec, 3 cm,
/// and 0.1 ms. Libration, some hundredths of a milliarcsec, is not in it.
struct SubdailyTides {};
inline constexpr SubdailyTides subdaily_tides{};

/// The word that claims what dX and dY of a file are, where its rows do not tell: EarthOrientation::read.
struct OffsetsFromIau2006 {};
inline constexpr OffsetsFromIau2006 offsets_from_iau_2006{};

/// The observed parameters of the Earth's orientation at an instant (IERS Conventions 2010, chapter 5), and
/// their derivatives by TAI. The functions that take them throw BadInput for one that is not finite, and for
/// a pole or an offset of more than 60 arcsec, a hundred times what has been observed, more than that in a
/// day, a gain of UT1 beyond 1e-6, twenty times as much: d(UT1-TAI)/dTAI, not the ratio of the two clocks; or
/// a UT1-TAI that makes |UT1-UTC| more than 0.9 s, as scale::Ut1 says.
struct EarthOrientationParameters {
  Quantity<si::angle> pole_x, pole_y;    ///< polar motion
  Quantity<si::time> ut1_minus_tai;      ///< UT1-UTC minus the leap seconds, so that it has no jumps
  Quantity<si::dimensionless> ut1_gain;  ///< d(UT1-TAI)/dTAI
  Quantity<si::angle> dX, dY;            ///< offsets of the celestial pole from IAU 2006/2000A
  Quantity<si::angular_velocity> pole_x_rate{}, pole_y_rate{}, dX_rate{}, dY_rate{};
};

/// The rotation of the Earth by IAU 2006/2000A, with the pole's observed offsets and polar motion:
///     R_itrf^gcrf = Q(X + dX, Y + dY, s) R3(-ERA(UT1)) W(x, y, s')
///     R3(t) = [cos t, sin t, 0; -sin t, cos t, 0; 0, 0, 1], of the axes, as the IERS writes it
///     w_gi^i = dERA/dUT1 (1 + d(UT1-TAI)/dTAI) along the celestial intermediate pole, and the motion of that
///              pole in Gcrf (below 1e-11 rad/s) and in Itrf (1e-13 rad/s)
/// It is gcrf_from_cirf(epoch, p) * cirf_from_tirf(epoch, p) * tirf_from_itrf(epoch, p). A call takes about
/// 0.2 ms, most of it for the series of X and Y; EarthMotion is a thousand times faster.
VECTRIX_EXPORT MovingDcm<earth::Gcrf, earth::Itrf> earth_rotation(
    const Epoch& epoch, const EarthOrientationParameters& parameters);

/// The observed orientation of the Earth, one row per day, from the IERS series finals2000A:
///     graph edge    edge(orientation)
/// Between rows each parameter is a cubic spline: twice continuously differentiable, and one cubic over the
/// first two days and over the last two. UT1 is interpolated as UT1-TAI, so that a leap second does not
/// matter. Away from the ends a change of one row changes the curve beyond the next row by at most 14 % of
/// it, and by 0.27 of that each day further. The series omits tides of a day and half a day (below 1
/// milliarcsecond). Outside the rows: BadInput with the epoch and the time interval of the rows. Copies are
/// cheap: they share the rows.
class VECTRIX_EXPORT EarthOrientation {
 public:
  /// Reads fixed columns: MJD 8-15, x 19-27 and y 38-46 (arcsec), UT1-UTC 59-68 (s), dX 98-106 and dY 117-125
  /// (milliarcsec). Lines that begin with '#' are comments. The series ends with predictions without all
  /// values: rows after the last complete one are not used. Throws BadInput with file, line, columns and
  /// reason if a field is no number, a complete row follows an incomplete one, rows are not a day apart,
  /// UT1-TAI jumps as at a leap second that ERFA does not know, the file ends within the columns of a line,
  /// or fewer than four rows are complete; if x or y changes by more than 15 milliarcsec in a day, three
  /// times as much as it did since 1973, or dX and dY by more than 3, as where rows of another series begin;
  /// and if they are not clearly nearer to zero than to the offsets from IAU 1980, which finals.all has in
  /// the same columns. From 1979 to 1990 both may be a few milliarcsec, as are the errors of that time. Rows
  /// of those years may not tell, in a short excerpt or in a long one that begins in 1980, and are then
  /// refused, unless you say what they are: read(file, offsets_from_iau_2006).
  static EarthOrientation read(const std::filesystem::path& finals2000A);
  static EarthOrientation read(const std::filesystem::path& finals2000A, OffsetsFromIau2006);

  /// A word for spans without data: the pole at x = y = dX = dY = 0, and UT1-TAI at its value at the start of
  /// the span, where UT1-UTC is given. From 1973 to 2026 x, y reach 0.6 arcsec, 19 m on the ground, and dX,
  /// dY 10 milliarcsec, since 2000 1; UT1 drifts by up to 4.1 ms a day, 1.9 m on the equator, since 2000 2.5
  /// ms. 0 for UT1-UTC is off by up to 0.9 s, 420 m, and by a second more with each leap second: at() then
  /// refuses |UT1-UTC| of more than 1.1 s, EarthMotion of more than 5 s. Throws BadInput if |UT1-UTC| exceeds
  /// 0.9 s, or the span has no duration, has more than 100 years, or starts before 1960.
  static EarthOrientation unobserved(const TimeSpan& span, const Quantity<si::time>& ut1_minus_utc);

  [[nodiscard]] const Epoch& first() const { return data_->epochs.front(); }
  [[nodiscard]] const Epoch& last() const { return data_->epochs.back(); }

  [[nodiscard]] EarthOrientationParameters parameters(const Epoch& epoch) const;
  /// With the tides of a day and half a day.
  [[nodiscard]] EarthOrientationParameters parameters(const Epoch& epoch, SubdailyTides) const;
  /// R_itrf^gcrf and w_gi^i.
  [[nodiscard]] MovingDcm<earth::Gcrf, earth::Itrf> at(const Epoch& epoch) const;
  /// The same with one origin: an edge of a frame graph.
  MovingTransform<earth::Gcrf, earth::Itrf> operator()(const Epoch& epoch) const {
    return coincident(at(epoch));
  }

 private:
  friend class EarthMotion;

  static EarthOrientation of_file(const std::filesystem::path& finals2000A, bool offsets_are_from_iau_2006);

  EarthOrientation(std::vector<Epoch> epochs, std::vector<EarthOrientationParameters> rows, bool is_observed);

  /// x, y, UT1-TAI, dX, dY, rad and s, and in the other columns their first and second derivatives by TAI,
  /// 1/s. Outside the rows the nearest cubic is continued.
  [[nodiscard]] Eigen::Matrix<double, 5, 3> curves(const Epoch& epoch) const;
  void require(const Epoch& epoch) const;

  struct Data {
    std::vector<Epoch> epochs;
    std::vector<EarthOrientationParameters> rows;
    bool is_observed;
  };
  std::shared_ptr<const Data> data_;
};

}  // namespace vectrix

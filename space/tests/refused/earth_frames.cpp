// Earth frames
#include <vectrix/space.hpp>

using namespace vectrix;
using earth::Cirf, earth::Eme2000, earth::Gcrf, earth::Itrf, earth::MeanOfDate, earth::Teme, earth::Tirf;
using earth::TrueOfDate;

struct Satellite : moving_frame {};

namespace teme_taken_for_gcrf {
// mistake: a vector of SGP4, in TEME, turned to ITRF as if it were in GCRF: 40 km in a low orbit
// expect: Left = (vectrix::)?Dcm<(vectrix::)?(earth::)?Itrf, (vectrix::)?(earth::)?Gcrf
// expect: Right = (vectrix::)?Displacement<(vectrix::)?(earth::)?Teme
auto place(const Displacement<Teme, Satellite, In<Teme>>& r_teme, const Dcm<Itrf, Gcrf>& R_itrf_from_gcrf,
           const MovingDcm<Teme, Itrf>& earth_in_teme) {
#ifdef REPAIRED
  static_cast<void>(R_itrf_from_gcrf);
  return inverse(earth_in_teme.rotation) * r_teme;
#else
  static_cast<void>(earth_in_teme);
  return R_itrf_from_gcrf * r_teme;
#endif
}
}  // namespace teme_taken_for_gcrf

namespace eme2000_taken_for_gcrf {
// mistake: an old catalogue's direction, in EME2000, added to one in GCRF
// expect: Eme2000
// expect: Gcrf
auto between(const Vector<Eme2000, si::dimensionless>& n_eme, const Vector<Gcrf, si::dimensionless>& n_gcrf) {
#ifdef REPAIRED
  return n_gcrf - inverse(eme2000_from_gcrf()) * n_eme;
#else
  return n_gcrf - n_eme;
#endif
}
}  // namespace eme2000_taken_for_gcrf

namespace mean_of_date_taken_for_true_of_date {
// mistake: a direction in the mean frame of date turned to ITRF without nutation: 0.6 km at the surface
// expect: Left = (vectrix::)?Dcm<(vectrix::)?(earth::)?Itrf, (vectrix::)?(earth::)?TrueOfDate
// expect: Right = (vectrix::)?Vector<(vectrix::)?(earth::)?MeanOfDate
auto on_the_earth(const Dcm<Itrf, TrueOfDate>& R_itrf_from_tod, const Dcm<TrueOfDate, MeanOfDate>& nutation,
                  const Vector<MeanOfDate, si::dimensionless>& n_mod) {
#ifdef REPAIRED
  return R_itrf_from_tod * nutation * n_mod;
#else
  static_cast<void>(nutation);
  return R_itrf_from_tod * n_mod;
#endif
}
}  // namespace mean_of_date_taken_for_true_of_date

namespace polar_motion_without_the_turn_of_the_day {
// mistake: polar motion applied to a position in the celestial intermediate frame
// expect: Left = (vectrix::)?Dcm<(vectrix::)?(earth::)?Itrf, (vectrix::)?(earth::)?Tirf
// expect: Right = (vectrix::)?Vector<(vectrix::)?(earth::)?Cirf
auto on_the_earth(const Dcm<Itrf, Tirf>& R_itrf_from_tirf, const Dcm<Tirf, Cirf>& R_tirf_from_cirf,
                  const Vector<Cirf, si::length>& r_cirf) {
#ifdef REPAIRED
  return R_itrf_from_tirf * R_tirf_from_cirf * r_cirf;
#else
  static_cast<void>(R_tirf_from_cirf);
  return R_itrf_from_tirf * r_cirf;
#endif
}
}  // namespace polar_motion_without_the_turn_of_the_day

namespace motion_of_the_earth_at_an_instant {
// mistake: the rotation of the Earth over a span, of one instant
// expect: \b(vectrix::)?Epoch\b
// expect: a TimeSpan
auto motion(const EarthOrientation& orientation, const Epoch& t) {
#ifdef REPAIRED
  return EarthMotion(orientation, from_until(t, 60.0 * si::second));
#else
  return EarthMotion(orientation, t);
#endif
}
}  // namespace motion_of_the_earth_at_an_instant

namespace teme_by_all_parameters {
// mistake: the rotation in TEME by the rows of a file, not by those of the instant
// expect: EarthOrientation
// expect: orientation.parameters\(epoch\)
auto rotation(const Epoch& t, const EarthOrientation& orientation) {
#ifdef REPAIRED
  return teme_from_itrf(t, orientation.parameters(t));
#else
  return teme_from_itrf(t, orientation);
#endif
}
}  // namespace teme_by_all_parameters

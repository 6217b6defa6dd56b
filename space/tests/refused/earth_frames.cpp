// Earth frames
#include <vectrix/space.hpp>

using namespace vectrix;
using earth::Eme2000, earth::Gcrf, earth::Itrf, earth::Teme;

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

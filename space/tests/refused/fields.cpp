// Gravity and magnetic field
#include <vectrix/space.hpp>

using namespace vectrix;
using earth::Gcrf, earth::Itrf;

struct Body : moving_frame {};

namespace gravity_at_inertial_position {
// mistake: the gravity at a position in inertial axes, with which the Earth does not turn
// expect: Vector<(vectrix::)?(earth::)?Gcrf
// expect: Vector<(vectrix::)?(earth::)?Itrf
Vector<Itrf, si::acceleration> gravity(const GravityField& field, const Dcm<Itrf, Gcrf>& R_itrf_from_gcrf,
                                       const Vector<Gcrf, si::length>& r_gcrf) {
#ifdef REPAIRED
  return field.acceleration(R_itrf_from_gcrf * r_gcrf);
#else
  static_cast<void>(R_itrf_from_gcrf);
  return field.acceleration(r_gcrf);
#endif
}
}  // namespace gravity_at_inertial_position

namespace bulge_without_an_exponent {
// mistake: does not say how far the bulge of the atmosphere reaches to the poles
// expect: HarrisPriester\(exponent\)
auto over_the_poles() {
#ifdef REPAIRED
  return HarrisPriester(6.0);
#else
  return HarrisPriester();
#endif
}
}  // namespace bulge_without_an_exponent

namespace bulge_of_an_inertial_sun {
// mistake: a position in axes of the Earth, and the Sun along the axes of GCRF: the bulge is hours away
// expect: Gcrf
// expect: r_itrf, to_the_sun
auto density(const HarrisPriester& model, const Dcm<Itrf, Gcrf>& R_itrf_from_gcrf,
             const Vector<Itrf, si::length>& r_itrf, const Displacement<Gcrf, sky::Sun, In<Gcrf>>& r_es) {
#ifdef REPAIRED
  return model.density(r_itrf, R_itrf_from_gcrf * r_es);
#else
  static_cast<void>(R_itrf_from_gcrf);
  return model.density(r_itrf, r_es);
#endif
}
}  // namespace bulge_of_an_inertial_sun

namespace gravity_gradient_across_frames {
// mistake: the gradient in axes of the Earth times a distance in axes of the body
// expect: Left = (vectrix::)?GravityGradient<(vectrix::)?(earth::)?Itrf
// expect: Right = (vectrix::)?Vector<Body
auto difference(const GravityGradient<Itrf>& G_itrf, const Dcm<Body, Itrf>& R_body_from_itrf,
                const Vector<Body, si::length>& d_body) {
#ifdef REPAIRED
  return R_body_from_itrf * G_itrf * d_body;
#else
  static_cast<void>(R_body_from_itrf);
  return G_itrf * d_body;
#endif
}
}  // namespace gravity_gradient_across_frames

namespace magnetic_field_as_nanotesla {
// mistake: nanotesla given for tesla
// expect: InFrame = (vectrix::)?In<Body>
// expect: nanotesla_unit
auto measured(double x, double y, double z) {
#ifdef REPAIRED
  const auto unit = convert<si::magnetic_flux_density>(1.0 * si::nanotesla);
#else
  const auto unit = 1.0 * si::nanotesla;
#endif
  return vector(in<Body>, x * unit, y * unit, z * unit);
}
}  // namespace magnetic_field_as_nanotesla

namespace magnetic_torque_across_frames {
// mistake: the dipole moment in axes of the body crossed with the field in axes of the Earth
// expect: Vector<Body, (vectrix::)?si::magnetic_dipole_moment
// expect: Vector<(vectrix::)?(earth::)?Itrf, (vectrix::)?si::magnetic_flux_density
// expect: expressed in one frame
auto torque(const Vector<Body, si::magnetic_dipole_moment>& m_body,
            const Vector<Itrf, si::magnetic_flux_density>& B_itrf, const Dcm<Body, Itrf>& R_body_from_itrf) {
#ifdef REPAIRED
  return cross(m_body, R_body_from_itrf * B_itrf);
#else
  static_cast<void>(R_body_from_itrf);
  return cross(m_body, B_itrf);
#endif
}
}  // namespace magnetic_torque_across_frames

namespace density_at_kilometres {
// mistake: the density of the atmosphere at a height in kilometres
// expect: kilometre_unit
// expect: convert<si::length>
auto density(const ExponentialAtmosphere& air, const Quantity<si::kilometre_unit>& height) {
#ifdef REPAIRED
  return air.density(convert<si::length>(height));
#else
  return air.density(height);
#endif
}
}  // namespace density_at_kilometres

// Inertia and mass properties
#include <vectrix/dynamics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Eci : inertial_frame {};
struct Body : moving_frame {};
struct Wheel : moving_frame {};
struct Satellite : moving_frame {};
struct Thruster : named_point {};
struct Hinge : named_point {};

namespace energy_of_inertia_about_hinge {
// mistake: the kinetic energy from the inertia about a point that may move
// expect: InertiaAbout = Hinge
auto energy(const Inertia<Body, Hinge>& J_hinge, const Inertia<Body>& J_body,
            const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return static_cast<void>(J_hinge), kinetic_energy(J_body, w_body);
#else
  return static_cast<void>(J_body), kinetic_energy(J_hinge, w_body);
#endif
}
}  // namespace energy_of_inertia_about_hinge

namespace energy_of_other_body {
// mistake: the kinetic energy of the inertia of one body with the rate of another
// expect: kinetic_energy
// expect: Wheel
// expect: Body
#ifdef REPAIRED
auto energy(const Inertia<Wheel>& J_wheel, const AngularVelocity<Eci, Wheel, In<Wheel>>& w_wheel) {
#else
auto energy(const Inertia<Wheel>& J_wheel, const AngularVelocity<Eci, Body, In<Body>>& w_wheel) {
#endif
  return kinetic_energy(J_wheel, w_wheel);
}
}  // namespace energy_of_other_body

namespace energy_of_rate_in_reference {
// mistake: the kinetic energy of an inertia in the body's axes with a rate in the reference's
// expect: kinetic_energy
// expect: Eci
// expect: Body
auto energy(const Inertia<Body>& J_body, const Dcm<Body, Eci>& R_body_from_eci,
            const AngularVelocity<Eci, Body, In<Eci>>& w_eci) {
#ifdef REPAIRED
  return kinetic_energy(J_body, R_body_from_eci * w_eci);
#else
  static_cast<void>(R_body_from_eci);
  return kinetic_energy(J_body, w_eci);
#endif
}
}  // namespace energy_of_rate_in_reference

namespace inertia_default {
// mistake: an inertia that nobody gave
// expect: Inertia<Body
auto satellite() {
#ifdef REPAIRED
  const auto moment = 3.0 * si::kilogram_square_metre;
  const Inertia<Body> J_body = inertia_from_principal_moments(in<Body>, moment, moment, moment);
#else
  const Inertia<Body> J_body;
#endif
  return J_body;
}
}  // namespace inertia_default

namespace inertia_from_bare_matrix {
// mistake: a bare matrix as an inertia: nothing says whose, nor which sign its off-diagonal numbers have
// expect: Inertia<Body
// expect: (Eigen::Matrix<double, 3, 3>|Matrix3d)
auto satellite(const Eigen::Matrix3d& J) {
#ifdef REPAIRED
  const Inertia<Body> J_body = trust_inertia(in<Body>, J);
#else
  const Inertia<Body> J_body = J;
#endif
  return J_body;
}
}  // namespace inertia_from_bare_matrix

namespace inertia_from_bare_numbers {
// mistake: moments of inertia without a unit
// expect: inertia_from_principal_moments
// expect: in kg m.2
// expect: double
auto satellite() {
#ifdef REPAIRED
  const auto unit = si::kilogram_square_metre;
#else
  const double unit = 1.0;
#endif
  return inertia_from_principal_moments(in<Body>, 3.0 * unit, 4.0 * unit, 5.0 * unit);
}
}  // namespace inertia_from_bare_numbers

namespace inertia_of_masses {
// mistake: masses, kg, for moments of inertia, kg m^2
// expect: inertia_from_principal_moments
// expect: si::mass
auto satellite() {
#ifdef REPAIRED
  const auto unit = si::kilogram_square_metre;
#else
  const auto unit = si::kilogram;
#endif
  return inertia_from_principal_moments(in<Body>, 3.0 * unit, 4.0 * unit, 5.0 * unit);
}
}  // namespace inertia_of_masses

namespace inertia_of_unnamed_products {
// mistake: products of inertia in the order of a table that lists xy, yz, zx
// expect: inertia_from_moments_and_products
// expect: xy.Pxy., xz.Pxz., yz.Pyz.
auto satellite(const Quantity<si::moment_of_inertia>& moment, const Quantity<si::moment_of_inertia>& Pxy,
               const Quantity<si::moment_of_inertia>& Pyz, const Quantity<si::moment_of_inertia>& Pzx) {
#ifdef REPAIRED
  return inertia_from_moments_and_products(in<Body>, moment, moment, moment, xy(Pxy), yz(Pyz), zx(Pzx));
#else
  return inertia_from_moments_and_products(in<Body>, moment, moment, moment, Pxy, Pyz, Pzx);
#endif
}
}  // namespace inertia_of_unnamed_products

namespace inertia_product_given_twice {
// mistake: one product of inertia given twice, another left out
// expect: inertia_from_tensor
// expect: OffDiagonal<1, 2
// expect: xy.Jxy., xz.Jxz., yz.Jyz.
auto satellite(const Quantity<si::moment_of_inertia>& moment, const Quantity<si::moment_of_inertia>& J) {
#ifdef REPAIRED
  return inertia_from_tensor(in<Body>, moment, moment, moment, xy(J), yz(J), xz(J));
#else
  return inertia_from_tensor(in<Body>, moment, moment, moment, xy(J), yz(J), xy(J));
#endif
}
}  // namespace inertia_product_given_twice

namespace inertia_rotated_by_inverse {
// mistake: an inertia re-expressed by the rotation that leads to its frame instead of from it
// expect: Dcm<Body, Eci
// expect: Inertia<Body
auto in_eci(const Inertia<Body>& J_body, const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return inverse(R_body_from_eci) * J_body;
#else
  return R_body_from_eci * J_body;
#endif
}
}  // namespace inertia_rotated_by_inverse

namespace inertia_shifted_by_centre_of_other_body {
// mistake: parallel axes with the centre of mass of another body
// expect: Inertia<Body
// expect: Displacement<(vectrix::)?CentreOfMassOf<Wheel>, Hinge
auto about_hinge(const Inertia<Body>& J_body, const Displacement<CentreOfMassOf<Body>, Hinge, In<Body>>& r_bh,
                 const Displacement<CentreOfMassOf<Wheel>, Hinge, In<Body>>& r_wh,
                 const Quantity<si::mass>& m) {
#ifdef REPAIRED
  return static_cast<void>(r_wh), shift(J_body, r_bh, m);
#else
  return static_cast<void>(r_bh), shift(J_body, r_wh, m);
#endif
}
}  // namespace inertia_shifted_by_centre_of_other_body

namespace inertia_shifted_without_centre_of_mass {
// mistake: parallel axes between two points of which none is the centre of mass
// expect: Inertia<Body, Hinge
// expect: Displacement<Hinge, Thruster
auto about_thruster(const Inertia<Body, Hinge>& J_hinge, const Displacement<Hinge, Thruster, In<Body>>& r_ht,
                    const Displacement<Hinge, CentreOfMassOf<Body>, In<Body>>& r_hc,
                    const Quantity<si::mass>& m) {
#ifdef REPAIRED
  return shift(shift(J_hinge, r_hc, m), -r_hc + r_ht, m);
#else
  return static_cast<void>(r_hc), shift(J_hinge, r_ht, m);
#endif
}
}  // namespace inertia_shifted_without_centre_of_mass

namespace inertia_sum_about_two_points {
// mistake: inertias about different points joined: each about its own centre of mass
// expect: Inertia<Body
// expect: Inertia<Wheel
auto satellite(const Inertia<Body, Hinge>& J_body,
               const Inertia<Wheel, CentreOfMassOf<Wheel>, In<Body>>& J_wheel,
               const Displacement<CentreOfMassOf<Wheel>, Hinge, In<Body>>& r_wh,
               const Quantity<si::mass>& m) {
#ifdef REPAIRED
  return join(of<Satellite>, J_body, shift(J_wheel, r_wh, m));
#else
  return static_cast<void>(r_wh), static_cast<void>(m), join(of<Satellite>, J_body, J_wheel);
#endif
}
}  // namespace inertia_sum_about_two_points

namespace inertia_sum_in_two_frames {
// mistake: inertias expressed in different frames joined
// expect: Inertia<Body, Hinge
// expect: Inertia<Wheel, Hinge
auto satellite(const Inertia<Body, Hinge>& J_body, const Inertia<Wheel, Hinge>& J_wheel,
               const Dcm<Body, Wheel>& R_body_from_wheel) {
#ifdef REPAIRED
  return join(of<Satellite>, J_body, R_body_from_wheel * J_wheel);
#else
  return static_cast<void>(R_body_from_wheel), join(of<Satellite>, J_body, J_wheel);
#endif
}
}  // namespace inertia_sum_in_two_frames

namespace inertia_sum_without_name {
// mistake: inertias added, when nothing says of which body the sum is
// expect: Inertia<Body, Hinge
// expect: Inertia<Wheel, Hinge
auto satellite(const Inertia<Body, Hinge>& J_body, const Inertia<Wheel, Hinge, In<Body>>& J_wheel) {
#ifdef REPAIRED
  return join(of<Satellite>, J_body, J_wheel);
#else
  return J_body + J_wheel;
#endif
}
}  // namespace inertia_sum_without_name

namespace inertia_times_alpha_of_other_body {
// mistake: the inertia of one body times the angular acceleration of another
// expect: Left = (vectrix::)?Inertia<Wheel
// expect: Right = (vectrix::)?AngularAcceleration<Gcrf, Body
// expect: the kinds go together
auto torque([[maybe_unused]] const Inertia<Wheel>& J_wheel, [[maybe_unused]] const Inertia<Body>& J_body,
            const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_body) {
#ifdef REPAIRED
  return J_body * alpha_body;
#else
  return J_wheel * alpha_body;
#endif
}
}  // namespace inertia_times_alpha_of_other_body

namespace mass_properties_from_two_origins {
// mistake: parts joined whose centres of mass are given from different origins
// expect: MassProperties<Body
// expect: MassProperties<Wheel
auto satellite(const MassProperties<Body>& body, const MassProperties<Wheel, Wheel, In<Body>>& wheel,
               const Displacement<Wheel, Body, In<Body>>& r_wb) {
#ifdef REPAIRED
  return join(of<Satellite>, body, shift(wheel, r_wb));
#else
  return static_cast<void>(r_wb), join(of<Satellite>, body, wheel);
#endif
}
}  // namespace mass_properties_from_two_origins

namespace mass_properties_of_two_bodies {
// mistake: the centre of mass of one body with the inertia of another
// expect: Inertia<Wheel
// expect: CentreOfMassOf<Body>
auto wheel(const Quantity<si::mass>& m, const Displacement<Body, CentreOfMassOf<Body>, In<Wheel>>& r_body,
           const Displacement<Body, CentreOfMassOf<Wheel>, In<Wheel>>& r_wheel,
           const Inertia<Wheel>& J_wheel) {
#ifdef REPAIRED
  return static_cast<void>(r_body), mass_properties(m, r_wheel, J_wheel);
#else
  return static_cast<void>(r_wheel), mass_properties(m, r_body, J_wheel);
#endif
}
}  // namespace mass_properties_of_two_bodies

namespace momentum_as_torque {
// mistake: an angular momentum taken for a torque
// expect: si::angular_momentum
// expect: si::torque
Vector<Body, si::torque> gyroscopic(const Inertia<Body>& J_body,
                                    const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return cross(w_body.vector(), J_body * w_body);
#else
  return J_body * w_body;
#endif
}
}  // namespace momentum_as_torque

namespace momentum_of_inertia_about_hinge {
// mistake: the inertia about a point that may move, times the rate, as the momentum about the centre of mass
// expect: Inertia<Body, Hinge
// expect: AngularVelocity<Eci, Body
auto momentum(const Inertia<Body, Hinge>& J_hinge, const Inertia<Body>& J_body,
              const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return static_cast<void>(J_hinge), J_body * w_body;
#else
  return static_cast<void>(J_body), J_hinge * w_body;
#endif
}
}  // namespace momentum_of_inertia_about_hinge

namespace momentum_of_other_body {
// mistake: the inertia of one body times the rate of another
// expect: Inertia<Wheel
// expect: AngularVelocity<Eci, Body
auto momentum(const Inertia<Wheel>& J_wheel, const AngularVelocity<Eci, Wheel, In<Wheel>>& w_wheel,
              const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return static_cast<void>(w_body), J_wheel * w_wheel;
#else
  return static_cast<void>(w_wheel), J_wheel * w_body;
#endif
}
}  // namespace momentum_of_other_body

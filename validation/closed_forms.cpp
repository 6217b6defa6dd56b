#include <cmath>
#include <utility>
#include <vectrix/dynamics.hpp>

#include "comparison.hpp"
#include "difference.hpp"

// Runs of crafts with joints, rotors and modes whose motion, or a part of it, can be written down.
namespace vectrix::validation {
namespace closed_forms {
namespace {

using Eigen::Vector3d;
struct Bus : moving_frame {};
struct Disc : moving_frame {};
struct Whole : moving_frame {};
struct Bob : moving_frame {};
struct Boom : moving_frame {};
struct Dish : moving_frame {};
struct Slug : moving_frame {};
struct Wheel : named_point {};
struct Panel : named_point {};

constexpr auto s = si::second;
constexpr auto m = si::metre;
constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;
constexpr auto kg = si::kilogram;
constexpr auto kg_m2 = si::kilogram_square_metre;

// Steps by the thousand, each with a rounding of some 1e-16 of numbers of order 1.
constexpr double tolerance = 1e-12;
constexpr const char* reason = "rounding of the integration";

CraftPropagation precise(double end_s) {
  return {.end = end_s * s,
          .relative_tolerance = 1e-14,
          .absolute_tolerances = {1e-15 * rad, 1e-15 * rad_s, 1e-15 * m, 1e-15 * (m / s), 1e-15}};
}
/// A body of the frame b whose mass properties are about the origin, and in the axes, of p.
template <Frame B, Frame P>
MassProperties<B, P, In<P>> placed(double mass_kg, const Transform<P, B>& centre, const Vector3d& moments) {
  return mass_properties(
      mass_kg * kg, displacement(of<CentreOfMassOf<B>>, relative_to<P>, centre.translation.vector()),
      centre.rotation * inertia_from_principal_moments(in<B>, moments.x() * kg_m2, moments.y() * kg_m2,
                                                       moments.z() * kg_m2));
}
template <Frame P, Frame B> Transform<P, B> place(double angle, const Vector3d& axis_p, const Vector3d& r_p) {
  return {dcm(to<P>, from<B>, Eigen::AngleAxisd(angle, axis_p.normalized()).toRotationMatrix()),
          displacement(of<B>, relative_to<P>, vector<si::length>(in<P>, r_p))};
}
template <Frame B> MassProperties<B> mass(double mass_kg, const Vector3d& c_b, const Vector3d& moments) {
  return mass_properties(
      mass_kg * kg, displacement(of<CentreOfMassOf<B>>, relative_to<B>, vector<si::length>(in<B>, c_b)),
      inertia_from_principal_moments(in<B>, moments.x() * kg_m2, moments.y() * kg_m2, moments.z() * kg_m2));
}
MovingTransform<Inertial, Body> hub(const Vector3d& w_b, const Vector3d& v_i) {
  return {moving_dcm(
              aligned(to<Inertial>, from<Body>),
              angular_velocity(of<Body>, relative_to<Inertial>, vector<si::angular_velocity>(in<Body>, w_b))),
          coincident(of<Body>, relative_to<Inertial>, in<Inertial>),
          velocity(of<Body>, relative_to<Inertial>, observed_from<Inertial>,
                   vector<si::velocity>(in<Inertial>, v_i))};
}
void grow(double& largest, double found, double exact) {
  largest = detail::larger(largest, std::abs(found - exact));
}
Row row(const char* what, const char* compared, const char* unit, double scale, double reached) {
  return {"Closed forms of crafts with parts", what, compared, tolerance * scale, unit, reason, reached};
}

// A wheel that is symmetric about its axis, as a body on a hinge, and as a rotor of the hub and wheel joined.
Rows rotor_rows() {
  const auto bus =
      placed<Bus>(40.0, place<Body, Bus>(0.4, {1.0, 0.5, -0.2}, {0.05, -0.02, 0.1}), {8.0, 6.0, 9.0});
  const auto at = place<Body, Disc>(0.9, {0.3, 1.0, -0.7}, {-0.2, 0.1, 0.3});
  const Vector3d moments(0.05, 0.05, 0.08);
  const auto hinged =
      spacecraft(body(bus, free_in<Inertial>),
                 body(mass<Disc>(3.0, Vector3d::Zero(), moments), hinge(at, unit_z(in<Disc>))));
  const auto balanced =
      spacecraft(body(join(of<Whole>, bus, placed<Disc>(3.0, at, moments)), free_in<Inertial>),
                 rotor(of<Wheel>, at.rotation * unit_z(in<Disc>), moments.z() * kg_m2));
  using Hinged = std::remove_const_t<decltype(hinged)>;
  using Balanced = std::remove_const_t<decltype(balanced)>;
  const auto torque = [](const Quantity<si::time>& t) {
    return 0.2 * std::cos(t.value()) * si::newton_metre;
  };
  const auto start = hub({0.3, 0.4, -0.2}, Vector3d::Zero());
  const double end_s = 20.0;
  const auto as_hinge = propagate(
      scenario(hinged,
               [=](const Now<Hinged>& now, Forces<Hinged>& f) { f.effort(of<Disc>, torque(now.time())); }),
      state(hinged, 0.0 * s, start, starts(of<Disc>, 0.0 * rad, 20.0 * rad_s)), precise(end_s));
  const auto as_rotor =
      propagate(scenario(balanced, [=](const Now<Balanced>& now,
                                       Forces<Balanced>& f) { f.motor(of<Wheel>, torque(now.time())); }),
                state(balanced, 0.0 * s, start, spins(of<Wheel>, 20.0 * rad_s)), precise(end_s));
  Difference difference;
  double spin = 0.0;
  for (double t_s = 0.5; t_s <= end_s; t_s += 0.5) {
    const auto a = as_rotor.at(t_s * s);
    const auto b = as_hinge.at(t_s * s);
    difference.attitude(a.hub_motion().turning.rotation, b.hub_motion().turning.rotation.matrix());
    difference.rate(a.hub_motion().turning.angular_velocity,
                    b.hub_motion().turning.angular_velocity.coordinates());
    difference.position(a.hub_motion().translation, b.hub_motion().translation.coordinates());
    grow(spin, a.spin(of<Wheel>).value(), b.speed(of<Disc>).value());
  }
  const char* what = "a rotor with a motor, and the same wheel on a hinge, 20 s";
  const double turned = start.turning.angular_velocity.coordinates().norm() * end_s;
  return {row(what, "attitude of the hub", "rad", turned, difference.attitude_rad),
          row(what, "rate of the hub", "rad/s", turned, difference.rate_rad_s),
          row(what, "position of the hub", "m", turned, difference.position_m),
          row(what, "speed of the wheel", "rad/s", 20.0 * turned, spin)};
}

// Liquid in a tank as a pendulum on a free hub that a thrust F accelerates. With mu = m M / (m + M),
//   q'' = -W^2 sin q,  W^2 = mu F l / (M (J + mu l^2)),
// and from rest at q_0 it has the period 4 K(k) / W, k = sin(q_0 / 2), and at the bottom the rate 2 k W.
Rows pendulum_rows() {
  const double M = 40.0, m_bob = 10.0, l = 0.7, J = 0.2, F = 80.0, q_0 = 2.0, mu = m_bob * M / (m_bob + M);
  const auto craft =
      spacecraft(body(mass<Body>(M, Vector3d::Zero(), {8.0, 6.0, 9.0}), free_in<Inertial>),
                 body(mass<Bob>(m_bob, {l, 0.0, 0.0}, {J, J, J}),
                      hinge(place<Body, Bob>(0.0, Vector3d::UnitZ(), Vector3d::Zero()), unit_z(in<Bob>))));
  using Craft = std::remove_const_t<decltype(craft)>;
  const double W = std::sqrt(mu * F * l / (M * (J + mu * l * l))), k = std::sin(q_0 / 2.0);
  const double quarter_s = std::comp_ellint_1(k) / W;
  const int quarters = 40;
  const auto flight = propagate(
      scenario(craft,
               [F](const Now<Craft>&, Forces<Craft>& forces) {
                 forces.force(of<Body>, -F * si::newton * unit_x(in<Body>));
               }),
      state(craft, 0.0 * s, hub(Vector3d::Zero(), Vector3d::Zero()), starts(of<Bob>, q_0 * rad, 0.0 * rad_s)),
      precise(quarters * quarter_s));
  double angle = 0.0, rate = 0.0;
  for (int i = 1; i < quarters; ++i) {
    const auto now = flight.at(i * quarter_s * s);
    const double sign = i % 4 < 2 ? 1.0 : -1.0;  // +, at the bottom falling, -, at the bottom rising
    if (i % 2 == 0) grow(angle, now.coordinate(of<Bob>).value(), i % 4 == 0 ? q_0 : -q_0);
    if (i % 2 == 1) {
      grow(angle, now.coordinate(of<Bob>).value(), 0.0);
      grow(rate, now.speed(of<Bob>).value(), -sign * 2.0 * k * W);
    }
  }
  const char* what = "slosh as a pendulum in a free hub under thrust, 115 degrees, 10 periods";
  const double swung = 2.0 * q_0 * quarters / 2;  // an error of phase grows with the angle swung
  return {row(what, "angle at each quarter of a period", "rad", swung, angle),
          row(what, "rate at the bottom", "rad/s", swung * W, rate)};
}

// eta'' (1 - t^2 / M) = -W^2 eta, and the hub moves by -(t / M) eta; about an axis of the hub through its
// centre the same with J for M, r for t.
Rows mode_rows() {
  const double M = 5.0, J = 3.0, W = 1.7, eta_0 = 0.02, end_s = 40.0;
  Rows rows;
  for (const bool turning : {false, true}) {
    const double part = turning ? 0.9 : 1.1, mass_of_motion = turning ? J : M;
    const Vector3d r = turning ? Vector3d(0.0, 0.0, part) : Vector3d::Zero();
    const Vector3d t = turning ? Vector3d::Zero() : Vector3d(part, 0.0, 0.0);
    const auto craft = spacecraft(body(mass<Body>(M, Vector3d::Zero(), {J, J, J}), free_in<Inertial>),
                                  modes(of<Panel>, on<Body>, FlexibleMode<Body>{r, t, W * rad_s, 0.0}));
    const auto flight = propagate(
        scenario(craft),
        state(craft, 0.0 * s, hub(Vector3d::Zero(), Vector3d::Zero()), deflects(of<Panel>, eta_0, 0.0)),
        precise(end_s));
    const double of_free = W / std::sqrt(1.0 - part * part / mass_of_motion);
    double deflection = 0.0, moved = 0.0;
    for (double t_s = 0.5; t_s <= end_s; t_s += 0.5) {
      const auto now = flight.at(t_s * s);
      const double eta = eta_0 * std::cos(of_free * t_s);
      const auto motion = now.hub_motion();
      grow(deflection, now.deflections(of<Panel>)[0], eta);
      grow(moved,
           turning ? log(motion.turning.rotation).coordinates().z() : motion.translation.coordinates().x(),
           -part / mass_of_motion * (eta - eta_0));
    }
    const char* what = turning ? "a mode that turns a free hub, 40 s" : "a mode that moves a free hub, 40 s";
    const double phase = of_free * end_s;  // an error of the frequency grows with the phase
    rows.push_back(row(what, "deflection", "kg^1/2 m", eta_0 * phase, deflection));
    rows.push_back(row(what, turning ? "angle of the hub" : "position of the hub", turning ? "rad" : "m",
                       eta_0 * phase, moved));
  }
  return rows;
}

// A hub, a boom on a hinge with a dish on a gimbal, a mass on a slider, a wheel, a mode on the dish: no
// loads.
Rows conservation_rows() {
  const auto craft = spacecraft(
      body(mass<Body>(40.0, {0.05, -0.02, 0.1}, {8.0, 6.0, 9.0}), free_in<Inertial>),
      rotor(of<Wheel>, unit_y(in<Body>), 0.05 * kg_m2),
      body(mass<Boom>(4.0, {0.0, -1.0, 0.2}, {1.5, 0.2, 1.5}),
           hinge(place<Body, Boom>(0.3, {1.0, 0.2, 0.0}, {0.1, -0.6, 0.0}), unit_z(in<Boom>))),
      body(mass<Dish>(2.0, {0.1, 0.0, 0.3}, {0.3, 0.3, 0.4}),
           gimbal(place<Boom, Dish>(-0.5, {0.0, 1.0, 0.5}, {0.0, -2.0, 0.0}), unit_x(in<Dish>),
                  unit_y(in<Dish>))),
      modes(of<Panel>, on<Dish>, FlexibleMode<Dish>{{0.1, 0.2, 0.0}, {0.3, 0.0, 0.2}, 3.0 * rad_s, 0.0}),
      body(mass<Slug>(3.0, {0.0, 0.02, 0.0}, {0.02, 0.02, 0.02}),
           slider(place<Body, Slug>(0.2, {0.0, 1.0, 1.0}, {-0.3, 0.1, 0.2}), unit_x(in<Slug>))));
  const auto flight = scenario(craft);
  const auto trajectory =
      propagate(flight,
                state(craft, 0.0 * s, hub({0.3, -0.2, 0.5}, {0.1, 0.2, -0.3}), spins(of<Wheel>, 40.0 * rad_s),
                      starts(of<Boom>, 0.2 * rad, -0.3 * rad_s),
                      starts(of<Dish>, 0.1 * rad, 0.4 * rad_s, -0.3 * rad, 0.2 * rad_s),
                      deflects(of<Panel>, 0.02, -0.1), starts(of<Slug>, 0.1 * m, 0.05 * (m / s))),
                precise(20.0));
  const CraftConservation kept = conservation(flight, trajectory);
  const char* what = "a hinge, a gimbal, a slider, a wheel and a mode on a free hub, 20 s";
  return {row(what, "energy, relative change", "", 1.0, kept.energy.value()),
          row(what, "momentum, relative change", "", 1.0, kept.momentum.value()),
          row(what, "angular momentum, relative change", "", 1.0, kept.angular_momentum.value())};
}

}  // namespace
}  // namespace closed_forms

Rows closed_form_rows(const std::string&) {
  Rows rows;
  for (const auto part : {closed_forms::rotor_rows, closed_forms::pendulum_rows, closed_forms::mode_rows,
                          closed_forms::conservation_rows})
    for (const Row& row : part()) rows.push_back(row);
  return rows;
}

}  // namespace vectrix::validation

#include "nasa_runs.hpp"

namespace vectrix::validation {
namespace {

constexpr auto kg_m2 = si::kilogram_square_metre;

Vector<Inertial, si::length> r_i() {
  return vector<si::length>(in<Inertial>, Eigen::Vector3d(-4292653.41, 955168.47, 5139356.57));
}
Vector<Inertial, si::velocity> v_i() {
  return vector<si::velocity>(in<Inertial>, Eigen::Vector3d(109.649663, -7527.726490, 1484.521489));
}

// Local vertical, local horizontal: z to nadir, y along -h, x = y x z.
Dcm<Lvlh, Inertial> R_lvlh_from_i() {
  const auto z_i = -direction(r_i());
  const auto y_i = -direction(cross(r_i(), v_i()));
  return dcm_from_axes(to<Lvlh>, cross(y_i, z_i), y_i, z_i);
}

Dcm<Body, Lvlh> R_b_from_lvlh(const std::string& run) {
  struct Pitched : moving_frame {};
  if (run == "10A") {
    return turned_z(to<Body>, from<Pitched>, convert<si::angle>(1.0 * si::degree)) *
           turned_y(to<Pitched>, from<Lvlh>, convert<si::angle>(85.0 * si::degree));
  }
  return turned_y(to<Body>, from<Lvlh>, convert<si::angle>(-11.6 * si::degree));
}

Inertia<Body> inertia(const std::string& run) {
  if (run == "10A") {  // cylinder
    return inertia_from_principal_moments(in<Body>, 500.0 * kg_m2, 12250.0 * kg_m2, 12250.0 * kg_m2);
  }
  if (run == "8A" || run == "8B") {  // sphere
    return inertia_from_principal_moments(in<Body>, 0.4 * kg_m2, 0.4 * kg_m2, 0.4 * kg_m2);
  }
  // The International Space Station: the numbers are entries of the tensor, not products of inertia.
  return inertia_from_tensor(in<Body>, 1.02e8 * kg_m2, 0.91e8 * kg_m2, 1.64e8 * kg_m2, xy(-6.96e6 * kg_m2),
                             xz(-5.48e6 * kg_m2), yz(5.90e5 * kg_m2));
}

AngularVelocity<Inertial, Body, In<Body>> w_ib_b(const std::string& run) {
  if (run == "8A" || run == "9A") return at_rest(of<Body>, relative_to<Inertial>, in<Body>);
  // w_il^i = r x v / |r|^2; the body is at rest in the local frame.
  const Eigen::Vector3d w =
      r_i().coordinates().cross(v_i().coordinates()) / r_i().coordinates().squaredNorm();
  const auto w_il_i =
      angular_velocity(of<Lvlh>, relative_to<Inertial>, vector<si::angular_velocity>(in<Inertial>, w));
  const auto w_lb_b = at_rest(of<Body>, relative_to<Lvlh>, in<Body>);
  return R_b_from_lvlh(run) * R_lvlh_from_i() * w_il_i + w_lb_b;
}

std::optional<TorquePulse> pulse_of(const std::string& run) {
  if (run != "9A") return std::nullopt;
  return TorquePulse{1000.0 * si::second, 2000.0 * si::second, 10.0 * si::newton_metre * unit_x(in<Body>)};
}

template <class... Parts> auto motion_under(const NasaRun& run, double end_s, const Parts&... parts) {
  return [trajectory = propagate(scenario(run.craft, parts...), run.start, tight(end_s))](
             const Quantity<si::time>& t) { return trajectory.at(t); };
}

}  // namespace

NasaRun nasa_run(const std::string& name) {
  const Satellite craft = craft_of(inertia(name), free_in<Inertial>);
  const State<Inertial, Body> start{0.0 * si::second,
                                    quaternion(inverse(R_b_from_lvlh(name) * R_lvlh_from_i())), w_ib_b(name)};
  return {.craft = craft,
          .start = state(craft, start.time, moving(start, r_i(), v_i())),
          .mu = Quantity<si::gravitational_parameter>::from_value(3.986004415e14),
          .gravity_gradient = name == "10A",
          .pulse = pulse_of(name)};
}

std::function<CraftState<Satellite>(const Quantity<si::time>&)> fly(const NasaRun& run, double end_s) {
  if (run.gravity_gradient) return motion_under(run, end_s, point_mass(run.craft, run.mu));
  if (!run.pulse) return motion_under(run, end_s, point_field(run.mu));
  return motion_under(run, end_s, point_field(run.mu),
                      pulse(run.craft, of<Body>, run.pulse->torque_b, run.pulse->start, run.pulse->end));
}

}  // namespace vectrix::validation

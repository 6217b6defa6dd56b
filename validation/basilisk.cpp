#include <vectrix/dynamics.hpp>

#include "comparison.hpp"
#include "difference.hpp"

namespace vectrix::validation {
namespace {

constexpr double mrp_tolerance = 1e-9;                // published with nine digits
constexpr double relative_position_tolerance = 1e-9;  // the tolerance of Basilisk's own test

const Eigen::Vector3d w0(0.5, -0.4, 0.7);
const Eigen::Vector3d moments(500.0, 200.0, 300.0);

// Modified Rodrigues parameters of [BN]: turning n by sigma = n tan(phi/4) gives b, so that sigma = q_v/(1 +
// q_w) of q_n_from_b, with q_w >= 0.
Eigen::Vector3d mrp(const Quaternion<Inertial, Body>& q_n_from_b) {
  const Eigen::Quaterniond q = q_n_from_b.eigen();
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  return sign * q.vec() / (1.0 + sign * q.w());
}

// SCRotation starts with the angular momentum along -n3: the columns of [BN] are the inertial axes in body
// coordinates.
Dcm<Body, Inertial> R_b_from_n() {
  const Eigen::Vector3d n3 = -moments.cwiseProduct(w0).normalized();
  const Eigen::Vector3d n2 = Eigen::Vector3d(-0.1 * n3.y() / n3.x(), 0.1, 0.0).normalized();
  Eigen::Matrix3d columns;
  columns << n2.cross(n3), n2, n3;
  return dcm(to<Body>, from<Inertial>, columns);
}

Scenario<Inertial, Body> free_hub(const std::string& name) {
  Scenario<Inertial, Body> scenario{
      .inertia = inertia_from_principal_moments(in<Body>, moments.x() * si::kilogram_square_metre,
                                                moments.y() * si::kilogram_square_metre,
                                                moments.z() * si::kilogram_square_metre),
      .initial = {.time = 0.0 * si::second,
                  .q_i_from_b = quaternion_scalar_first(to<Inertial>, from<Body>, 1.0, 0.0, 0.0, 0.0),
                  .w_ib_b = angular_velocity(of<Body>, relative_to<Inertial>,
                                             vector<si::angular_velocity>(in<Body>, w0))}};
  if (name == "SCRotation") {
    scenario.initial.q_i_from_b = quaternion(inverse(R_b_from_n()));
  } else {
    scenario.mu = Quantity<si::gravitational_parameter>::from_value(3.986004415e14);
    scenario.initial.orbit = point_motion(
        of<CentreOfMassOf<Body>>, relative_to<Inertial>, observed_from<Inertial>,
        vector<si::length>(in<Inertial>,
                           Eigen::Vector3d(-4020338.690396649, 7490566.741852513, 5248299.211589362)),
        vector<si::velocity>(in<Inertial>,
                             Eigen::Vector3d(-5199.77710904224, -3436.681645356935, 1041.576797498721)));
  }
  return scenario;
}

}  // namespace

Rows basilisk_rows(const std::string& data) {
  const CsvTable published = CsvTable::read(
      data + "/basilisk_free_hub.csv", {"case", "t_s", "sigma1", "sigma2", "sigma3", "x_m", "y_m", "z_m"});
  Rows rows;
  for (std::size_t row = 0; row < published.rows(); ++row) {
    const auto number = [&](const char* name) { return published.number(row, name); };
    const std::string name(published.text(row, "case"));
    const auto scenario = free_hub(name);
    const auto state = propagate(scenario, tight(number("t_s"), {})).at(number("t_s") * si::second);
    const Eigen::Vector3d sigma(number("sigma1"), number("sigma2"), number("sigma3"));
    rows.push_back({"Basilisk", name, "modified Rodrigues parameters", mrp_tolerance, "",
                    "nine printed digits",
                    (mrp(state.q_i_from_b) - sigma).cwiseAbs().maxCoeff<Eigen::PropagateNaN>()});
    if (state.orbit) {
      const Eigen::Vector3d r(number("x_m"), number("y_m"), number("z_m"));
      rows.push_back({"Basilisk", name, "position, relative", relative_position_tolerance, "",
                      "the tolerance of Basilisk's own test",
                      (state.orbit->position.coordinates() - r).norm() / r.norm()});
    }
  }
  return rows;
}

}  // namespace vectrix::validation

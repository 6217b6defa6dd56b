#include <vectrix/dynamics.hpp>
#include <vectrix/space/files/csv_table.hpp>

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

Inertia<Body> inertia() {
  return inertia_from_principal_moments(in<Body>, moments.x() * si::kilogram_square_metre,
                                        moments.y() * si::kilogram_square_metre,
                                        moments.z() * si::kilogram_square_metre);
}
State<Inertial, Body> start_at(const Dcm<Inertial, Body>& R_n_from_b) {
  return {0.0 * si::second, quaternion(R_n_from_b),
          angular_velocity(of<Body>, relative_to<Inertial>, vector<si::angular_velocity>(in<Body>, w0))};
}

// The attitude of the hub that is only turning at a time.
Quaternion<Inertial, Body> turned_for(double t_s) {
  const Turning craft = craft_of(inertia(), turning_in<Inertial>);
  const auto start = state(craft, 0.0 * si::second, moving(start_at(inverse(R_b_from_n()))));
  return quaternion(propagate(scenario(craft), start, tight(t_s))(t_s * si::second).rotation);
}

MovingTransform<Inertial, Body> flown_for(double t_s) {
  const auto mu = Quantity<si::gravitational_parameter>::from_value(3.986004415e14);
  const auto r_i = vector<si::length>(
      in<Inertial>, Eigen::Vector3d(-4020338.690396649, 7490566.741852513, 5248299.211589362));
  const auto v_i = vector<si::velocity>(
      in<Inertial>, Eigen::Vector3d(-5199.77710904224, -3436.681645356935, 1041.576797498721));
  const Satellite craft = craft_of(inertia(), free_in<Inertial>);
  const auto start =
      state(craft, 0.0 * si::second, moving(start_at(aligned(to<Inertial>, from<Body>)), r_i, v_i));
  return propagate(scenario(craft, point_field(mu)), start, tight(t_s))(t_s * si::second);
}

}  // namespace

Rows basilisk_rows(const std::string& data) {
  const CsvTable published = CsvTable::read(
      data + "/basilisk_free_hub.csv", {"case", "t_s", "sigma1", "sigma2", "sigma3", "x_m", "y_m", "z_m"});
  Rows rows;
  for (std::size_t row = 0; row < published.rows(); ++row) {
    const auto number = [&](const char* name) { return published.number(row, name); };
    const std::string name(published.text(row, "case"));
    const Eigen::Vector3d sigma(number("sigma1"), number("sigma2"), number("sigma3"));
    const auto compare_attitude = [&](const Quaternion<Inertial, Body>& q_n_from_b) {
      rows.push_back({"Basilisk", name, "modified Rodrigues parameters", mrp_tolerance, "",
                      "nine printed digits",
                      (mrp(q_n_from_b) - sigma).cwiseAbs().maxCoeff<Eigen::PropagateNaN>()});
    };
    if (name == "SCRotation") {
      compare_attitude(turned_for(number("t_s")));
      continue;
    }
    const MovingTransform<Inertial, Body> flown = flown_for(number("t_s"));
    compare_attitude(quaternion(flown.turning.rotation));
    const Eigen::Vector3d r(number("x_m"), number("y_m"), number("z_m"));
    rows.push_back({"Basilisk", name, "position, relative", relative_position_tolerance, "",
                    "the tolerance of Basilisk's own test",
                    (flown.translation.coordinates() - r).norm() / r.norm()});
  }
  return rows;
}

}  // namespace vectrix::validation

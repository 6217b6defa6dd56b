#include <cmath>
#include <numbers>
#include <vectrix/dynamics.hpp>
#include <vectrix/space/files/csv_table.hpp>

#include "comparison.hpp"
#include "difference.hpp"

namespace vectrix::validation {
namespace {

constexpr double mrp_tolerance = 1e-9;                // published with nine digits
constexpr double relative_position_tolerance = 1e-9;  // the tolerance of Basilisk's own test
constexpr double last_digit_tolerance = 0.5;          // the error of a number rounded to its last digit
constexpr double rounded_position_tolerance = 5e-3;   // each coordinate is rounded to 1 cm

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

namespace orbit {
const auto mu = Quantity<si::gravitational_parameter>::from_value(3.986004415e14);
const auto r_i = vector<si::length>(
    in<Inertial>, Eigen::Vector3d(-4020338.690396649, 7490566.741852513, 5248299.211589362));
const auto v_i = vector<si::velocity>(
    in<Inertial>, Eigen::Vector3d(-5199.77710904224, -3436.681645356935, 1041.576797498721));
}  // namespace orbit

MovingTransform<Inertial, Body> flown_for(double t_s) {
  const Satellite craft = craft_of(inertia(), free_in<Inertial>);
  const auto start = state(craft, 0.0 * si::second,
                           moving(start_at(aligned(to<Inertial>, from<Body>)), orbit::r_i, orbit::v_i));
  return propagate(scenario(craft, point_field(orbit::mu)), start, tight(t_s))(t_s * si::second);
}

struct WheelX : named_point {};
struct WheelY : named_point {};
struct WheelZ : named_point {};

// BalancedWheels: a hub whose frame is off its centre of mass, and whose mass contains the wheels. The orbit
// is given of the centre, r_CN, and published of the frame, r_BN. The motors push for half a second; that of
// the third is commanded -0.5 N m, and limited to 0.2 N m.
MovingTransform<Inertial, Body> flown_on_wheels_for(double t_s) {
  const auto kg_m2 = si::kilogram_square_metre;
  const auto J_s = 0.15915494309189535 * kg_m2;
  const auto rpm = std::numbers::pi / 30.0 * (si::radian / si::second);
  const auto c_b = vector<si::length>(in<Body>, Eigen::Vector3d(-0.0002, 0.0001, 0.1));
  const auto craft = spacecraft(
      body(mass_properties(
               750.0 * si::kilogram, displacement(of<CentreOfMassOf<Body>>, relative_to<Body>, c_b),
               inertia_from_principal_moments(in<Body>, 900.0 * kg_m2, 800.0 * kg_m2, 600.0 * kg_m2)),
           free_in<Inertial>),
      rotor(of<WheelX>, unit_x(in<Body>), J_s), rotor(of<WheelY>, unit_y(in<Body>), J_s),
      rotor(of<WheelZ>, unit_z(in<Body>), J_s));
  using Craft = std::remove_const_t<decltype(craft)>;
  const auto w_b = vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(0.08, 0.01, 0.0));
  const Eigen::Vector3d c = c_b.coordinates(), v = w_b.coordinates().cross(c);  // the frames are aligned
  const MovingTransform<Inertial, Body> hub{
      moving_dcm(aligned(to<Inertial>, from<Body>), angular_velocity(of<Body>, relative_to<Inertial>, w_b)),
      displacement(of<Body>, relative_to<Inertial>, orbit::r_i - vector<si::length>(in<Inertial>, c)),
      velocity(of<Body>, relative_to<Inertial>, observed_from<Inertial>,
               orbit::v_i - vector<si::velocity>(in<Inertial>, v))};
  const auto zero = 0.0 * si::second, off = 0.5 * si::second;
  const auto start = state(craft, zero, hub, spins(of<WheelX>, 500.0 * rpm), spins(of<WheelY>, 200.0 * rpm),
                           spins(of<WheelZ>, -150.0 * rpm));
  const auto flight = scenario(craft, point_field<Craft>(orbit::mu),
                               pulse(craft, of<WheelX>, 0.2 * si::newton_metre, zero, off),
                               pulse(craft, of<WheelY>, 0.1 * si::newton_metre, zero, off),
                               pulse(craft, of<WheelZ>, -0.2 * si::newton_metre, zero, off));
  return propagate(flight, start, tight(t_s)).at(t_s * si::second).hub_motion();
}

// The largest error of three numbers printed with nine digits, each in units of its last.
double in_last_digits(const Eigen::Vector3d& error, const Eigen::Vector3d& printed) {
  const auto unit = [](double x) { return std::pow(10.0, std::floor(std::log10(std::abs(x))) - 8.0); };
  return error.cwiseQuotient(printed.unaryExpr(unit)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
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
    const Eigen::Vector3d r(number("x_m"), number("y_m"), number("z_m"));
    if (name == "BalancedWheels") {
      const MovingTransform<Inertial, Body> flown = flown_on_wheels_for(number("t_s"));
      const auto q_n_from_b = quaternion(flown.turning.rotation);
      compare_attitude(q_n_from_b);
      rows.push_back({"Basilisk", name, "modified Rodrigues parameters, each in units of its last digit",
                      last_digit_tolerance, "", "rounded to nine digits",
                      in_last_digits(mrp(q_n_from_b) - sigma, sigma)});
      rows.push_back({"Basilisk", name, "position, largest coordinate", rounded_position_tolerance, "m",
                      "printed to 1 cm",
                      (flown.translation.coordinates() - r).cwiseAbs().maxCoeff<Eigen::PropagateNaN>()});
      continue;
    }
    const MovingTransform<Inertial, Body> flown = flown_for(number("t_s"));
    compare_attitude(quaternion(flown.turning.rotation));
    rows.push_back({"Basilisk", name, "position, relative", relative_position_tolerance, "",
                    "the tolerance of Basilisk's own test",
                    (flown.translation.coordinates() - r).norm() / r.norm()});
  }
  return rows;
}

}  // namespace vectrix::validation

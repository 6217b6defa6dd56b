#include <cmath>
#include <vectrix/dynamics.hpp>

#include "comparison.hpp"
#include "difference.hpp"
#include "simbody_reference_scan.hpp"

// A joint whose motion is given, compared with Simbody's own prescribed motion.
namespace vectrix::validation {
namespace scanned_mirror {
namespace {

using Hub = Body;  // of the differences
struct Mirror : moving_frame {};

constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;
constexpr double accuracy = 1e-12;
constexpr double amplitude = 0.4, rate = 2.5, phase = 0.3, end_s = 20.0;

JointMotion<si::angle, si::angular_velocity, si::angular_acceleration> scan(const Quantity<si::time>& t) {
  const double at = rate * t.value() + phase;
  return {amplitude * std::sin(at) * rad, amplitude * rate * std::cos(at) * rad_s,
          -amplitude * rate * rate * std::sin(at) * (rad_s / si::second)};
}
template <Frame B> MassProperties<B> mass(const SimbodyScanBody& b) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  return mass_properties(
      b.mass_kg * si::kilogram,
      displacement(of<CentreOfMassOf<B>>, relative_to<B>,
                   vector<si::length>(in<B>, Eigen::Vector3d(b.centre_b.data()))),
      trust_inertia(in<B>, Eigen::Matrix3d(Eigen::Map<const RowMajor>(b.inertia_c_b.data()))));
}

Rows rows() {
  const Eigen::Matrix3d R_h_from_m =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()).matrix();
  const Eigen::Vector3d axis = Eigen::Vector3d(0.5, -1.0, 2.0).normalized();
  SimbodyScan given{{40.0, {0.05, -0.02, 0.1}, {8.0, 0.3, -0.2, 0.3, 6.0, 0.5, -0.2, 0.5, 9.0}},
                    {6.0, {0.1, 0.2, -0.15}, {0.9, 0.05, 0.02, 0.05, 0.7, -0.04, 0.02, -0.04, 1.1}},
                    {},
                    {0.3, 0.4, -0.2},
                    {axis.x(), axis.y(), axis.z()},
                    {0.2, -0.3, 0.25},
                    amplitude,
                    rate,
                    phase};
  for (int i = 0; i < 9; ++i) given.R_h_from_m[static_cast<std::size_t>(i)] = R_h_from_m(i / 3, i % 3);

  const Transform<Hub, Mirror> X_h_from_m{
      dcm(to<Hub>, from<Mirror>, R_h_from_m),
      displacement(of<Mirror>, relative_to<Hub>,
                   vector<si::length>(in<Hub>, Eigen::Vector3d(given.r_hm_h.data())))};
  const auto craft = spacecraft(
      body(mass<Hub>(given.hub), free_in<Inertial>),
      body(mass<Mirror>(given.mirror), hinge(X_h_from_m, vector<si::dimensionless>(in<Mirror>, axis))));
  const auto start = state(
      craft, 0.0 * si::second,
      MovingTransform<Inertial, Hub>{
          moving_dcm(
              aligned(to<Inertial>, from<Hub>),
              angular_velocity(of<Hub>, relative_to<Inertial>,
                               vector<si::angular_velocity>(in<Hub>, Eigen::Vector3d(given.w_ih_h.data())))),
          coincident(of<Hub>, relative_to<Inertial>, in<Inertial>),
          at_rest(of<Hub>, relative_to<Inertial>, observed_from<Inertial>, in<Inertial>)},
      starts(of<Mirror>, scan(0.0 * si::second).coordinate, scan(0.0 * si::second).speed));
  const auto flight = scenario(craft, prescribed(craft, of<Mirror>, scan));
  const CraftTolerances fine{1e-14 * rad, 1e-14 * rad_s, 1e-14 * si::metre, 1e-14 * (si::metre / si::second),
                             1e-14};
  const auto ours = propagate(
      flight, start, {.end = end_s * si::second, .relative_tolerance = 1e-13, .absolute_tolerances = fine});

  std::vector<double> times;
  for (double t = 0.0; t <= end_s; t += 0.5) times.push_back(t);
  long steps = 0;
  const auto theirs = simbody_scan(given, accuracy, times, steps);
  Difference difference;
  double angle = 0.0, torque = 0.0;
  for (const SimbodyScanSample& sample : theirs) {
    const auto now = motion_at(flight, ours, sample.t_s * si::second);
    const auto turning = now.state().turning();
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    difference.attitude(turning.rotation, Eigen::Map<const RowMajor>(sample.R_i_from_h.data()));
    difference.rate(turning.angular_velocity, Eigen::Map<const Eigen::Vector3d>(sample.w_ih_h.data()));
    angle = detail::larger(angle, std::abs(now.state().coordinate(of<Mirror>).value() - sample.angle));
    torque = detail::larger(torque, std::abs(now.holding_effort(of<Mirror>).value() - sample.torque_nm));
  }
  // The torque is that of some newton metre for each radian of an error.
  const double of_run = accuracy * static_cast<double>(steps);
  const std::string what = "a mirror on a free hub, scanned by a sine for 20 s",
                    reason = "Simbody's accuracy 1e-12 times its steps";
  const auto row = [&](const char* compared, double tolerance, const char* unit, double reached) {
    return Row{"Simbody, prescribed motion", what, compared, tolerance, unit, reason, reached};
  };
  return {row("attitude of the hub", of_run, "rad", difference.attitude_rad),
          row("rate of the hub", of_run, "rad/s", difference.rate_rad_s),
          row("angle of the mirror", of_run, "rad", angle),
          row("torque of the drive", 10.0 * of_run, "N m", torque)};
}

}  // namespace
}  // namespace scanned_mirror

Rows prescribed_rows(const std::string&) {
  return scanned_mirror::rows();
}

}  // namespace vectrix::validation

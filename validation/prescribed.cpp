#include <cmath>
#include <vectrix/dynamics.hpp>

#include "comparison.hpp"
#include "difference.hpp"
#include "simbody_reference_scan.hpp"

// Joints and a wheel whose motion is given, compared with Simbody's own prescribed motion.
namespace vectrix::validation {
namespace scanned_mirror {
namespace {

using Hub = Body;  // of the differences
struct Mirror : moving_frame {};
struct Wheel : named_point {};
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

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
  return mass_properties(
      b.mass_kg * si::kilogram,
      displacement(of<CentreOfMassOf<B>>, relative_to<B>,
                   vector<si::length>(in<B>, Eigen::Vector3d(b.centre_b.data()))),
      trust_inertia(in<B>, Eigen::Matrix3d(Eigen::Map<const RowMajor>(b.inertia_c_b.data()))));
}

constexpr auto rad_s2 = rad_s / si::second;
const CraftTolerances fine{1e-14 * rad, 1e-14 * rad_s, 1e-14 * si::metre, 1e-14 * (si::metre / si::second),
                           1e-14};

Eigen::Vector3d column(const std::array<double, 3>& v) {
  return Eigen::Vector3d(v.data());
}
std::array<double, 3> numbers(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
std::array<double, 9> by_rows(const Eigen::Matrix3d& m) {
  std::array<double, 9> list{};
  for (int i = 0; i < 9; ++i) list[static_cast<std::size_t>(i)] = m(i / 3, i % 3);
  return list;
}

SimbodyScan make_scan() {
  const Eigen::Matrix3d R_h_from_m =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()).matrix();
  return {{40.0, {0.05, -0.02, 0.1}, {8.0, 0.3, -0.2, 0.3, 6.0, 0.5, -0.2, 0.5, 9.0}},
          {6.0, {0.1, 0.2, -0.15}, {0.9, 0.05, 0.02, 0.05, 0.7, -0.04, 0.02, -0.04, 1.1}},
          by_rows(R_h_from_m),
          {0.3, 0.4, -0.2},
          numbers(Eigen::Vector3d(0.5, -1.0, 2.0).normalized()),
          {0.2, -0.3, 0.25},
          {amplitude, rate, phase}};
}
Transform<Hub, Mirror> place_of(const SimbodyScan& scan) {
  return {dcm(to<Hub>, from<Mirror>, Eigen::Matrix3d(Eigen::Map<const RowMajor>(scan.R_h_from_m.data()))),
          displacement(of<Mirror>, relative_to<Hub>, vector<si::length>(in<Hub>, column(scan.r_hm_h)))};
}
template <Frame B> Vector<B, si::dimensionless> axis(const std::array<double, 3>& axis_b) {
  return vector<si::dimensionless>(in<B>, column(axis_b));
}
MovingTransform<Inertial, Hub> hub_of(const SimbodyScan& scan) {
  return {moving_dcm(aligned(to<Inertial>, from<Hub>),
                     angular_velocity(of<Hub>, relative_to<Inertial>,
                                      vector<si::angular_velocity>(in<Hub>, column(scan.w_ih_h)))),
          coincident(of<Hub>, relative_to<Inertial>, in<Inertial>),
          at_rest(of<Hub>, relative_to<Inertial>, observed_from<Inertial>, in<Inertial>)};
}
CraftPropagation precise() {
  return {.end = end_s * si::second, .relative_tolerance = 1e-13, .absolute_tolerances = fine};
}

/// What Simbody finds at each half second, and the largest differences from it.
struct Compared {
  explicit Compared(const SimbodyScan& scan) {
    std::vector<double> times;
    for (double t = 0.0; t <= end_s; t += 0.5) times.push_back(t);
    theirs = simbody_scan(scan, accuracy, times, steps);
  }
  template <class Motion> void add_hub(const Motion& now, const SimbodyScanSample& sample) {
    const auto turning = now.state().turning();
    hub.attitude(turning.rotation, Eigen::Map<const RowMajor>(sample.R_i_from_h.data()));
    hub.rate(turning.angular_velocity, column(sample.w_ih_h));
  }
  static void add(double& largest, double ours, double theirs) {
    largest = detail::larger(largest, std::abs(ours - theirs));
  }
  /// Of a torque it is ten times as much: it is that of some newton metre for each radian of an error.
  [[nodiscard]] Row row(const std::string& what, const char* compared, const char* unit,
                        double reached) const {
    const double of_run = accuracy * static_cast<double>(steps);
    return {"Simbody, prescribed motion",
            what,
            compared,
            std::string{"N m"} == unit ? 10.0 * of_run : of_run,
            unit,
            "Simbody's accuracy 1e-12 times its steps",
            reached};
  }

  std::vector<SimbodyScanSample> theirs;
  long steps = 0;
  Difference hub;
};

Rows mirror_rows() {
  const SimbodyScan given = make_scan();
  const auto craft =
      spacecraft(body(mass<Hub>(given.hub), free_in<Inertial>),
                 body(mass<Mirror>(given.mirror), hinge(place_of(given), axis<Mirror>(given.axis_m))));
  const auto start =
      state(craft, 0.0 * si::second, hub_of(given),
            starts(of<Mirror>, scan(0.0 * si::second).coordinate, scan(0.0 * si::second).speed));
  const auto flight = scenario(craft, prescribed(craft, of<Mirror>, scan));
  const auto ours = propagate(flight, start, precise());
  Compared compared(given);
  double angle = 0.0, torque = 0.0;
  for (const SimbodyScanSample& sample : compared.theirs) {
    const auto now = motion_at(flight, ours, sample.t_s * si::second);
    compared.add_hub(now, sample);
    Compared::add(angle, now.state().coordinate(of<Mirror>).value(), sample.angle);
    Compared::add(torque, now.holding_effort(of<Mirror>).value(), sample.torque_nm);
  }
  const std::string what = "a mirror on a free hub, scanned by a sine for 20 s";
  return {compared.row(what, "attitude of the hub", "rad", compared.hub.attitude_rad),
          compared.row(what, "rate of the hub", "rad/s", compared.hub.rate_rad_s),
          compared.row(what, "angle of the mirror", "rad", angle),
          compared.row(what, "torque of the drive", "N m", torque)};
}

// The hub of Simbody has a wheel of its own mass; ours has its mass, and a rotor.
constexpr double J_s = 0.08, J_t = 0.05, wheel_kg = 3.0;

SimbodyScanBody with_wheel(const SimbodyScanBody& hub, const SimbodyScanWheel& wheel) {
  const double m = hub.mass_kg + wheel.body.mass_kg;
  const Eigen::Vector3d c_h = column(hub.centre_b), c_w = column(wheel.r_hw_h),
                        c = (hub.mass_kg * c_h + wheel.body.mass_kg * c_w) / m;
  const auto about = [&](const SimbodyScanBody& part, const Eigen::Vector3d& centre) -> Eigen::Matrix3d {
    const Eigen::Vector3d d = centre - c;
    return Eigen::Map<const RowMajor>(part.inertia_c_b.data()) +
           part.mass_kg * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
  };
  return {m, numbers(c), by_rows(about(hub, c_h) + about(wheel.body, c_w))};
}
RotorMotion throttle(const Quantity<si::time>& t) {
  const double at = 1.7 * t.value() + 0.6;
  return {60.0 * std::sin(at) * rad_s, 60.0 * 1.7 * std::cos(at) * rad_s2};
}

Rows gimbal_rows() {
  SimbodyScan given = make_scan();
  given.free_axis_m = numbers(Eigen::Vector3d(2.0, 0.3, 0.4).normalized());
  const Eigen::Vector3d n = Eigen::Vector3d(0.3, 1.0, -0.7).normalized();
  given.wheel = SimbodyScanWheel{
      {wheel_kg, {}, by_rows(J_t * Eigen::Matrix3d::Identity() + (J_s - J_t) * n * n.transpose())},
      {-0.2, 0.1, 0.3},
      numbers(n),
      {60.0, 1.7, 0.6}};
  const auto craft =
      spacecraft(body(mass<Hub>(with_wheel(given.hub, *given.wheel)), free_in<Inertial>),
                 body(mass<Mirror>(given.mirror),
                      gimbal(place_of(given), axis<Mirror>(given.axis_m), axis<Mirror>(*given.free_axis_m))),
                 rotor(of<Wheel>, axis<Hub>(given.wheel->axis_h), J_s * si::kilogram_square_metre));
  const auto zero = 0.0 * si::second;
  const auto start =
      state(craft, zero, hub_of(given),
            starts(of<Mirror>, scan(zero).coordinate, scan(zero).speed, 0.0 * rad, 0.0 * rad_s),
            spins(of<Wheel>, throttle(zero).speed));
  const auto flight = scenario(craft, prescribed(craft, of<Mirror>, about_axis<1>, scan),
                               prescribed(craft, of<Wheel>, throttle));
  const auto ours = propagate(flight, start, precise());
  Compared compared(given);
  double angle = 0.0, torque = 0.0, free = 0.0, rate_about_free = 0.0, spin = 0.0, motor = 0.0;
  for (const SimbodyScanSample& sample : compared.theirs) {
    const auto now = motion_at(flight, ours, sample.t_s * si::second);
    compared.add_hub(now, sample);
    const auto q = now.state().coordinate(of<Mirror>);
    Compared::add(angle, q[0].value(), sample.angle);
    Compared::add(free, q[1].value(), sample.free_angle);
    Compared::add(rate_about_free, now.state().speed(of<Mirror>)[1].value(), sample.free_rate);
    Compared::add(torque, now.holding_effort(of<Mirror>)[0].value(), sample.torque_nm);
    Compared::add(spin, now.state().spin(of<Wheel>).value(), sample.spin);
    Compared::add(motor, now.holding_effort(of<Wheel>).value(), sample.wheel_torque_nm);
  }
  const std::string what =
      "a mirror on a gimbal, scanned about one axis, free about the other, and a wheel whose speed is a "
      "sine, 20 s";
  return {compared.row(what, "attitude of the hub", "rad", compared.hub.attitude_rad),
          compared.row(what, "rate of the hub", "rad/s", compared.hub.rate_rad_s),
          compared.row(what, "angle about the driven axis", "rad", angle),
          compared.row(what, "torque of the drive", "N m", torque),
          compared.row(what, "angle about the free axis", "rad", free),
          compared.row(what, "rate about the free axis", "rad/s", rate_about_free),
          compared.row(what, "speed of the wheel", "rad/s", spin),
          compared.row(what, "torque on the wheel", "N m", motor)};
}

}  // namespace
}  // namespace scanned_mirror

Rows prescribed_rows(const std::string&) {
  Rows rows = scanned_mirror::mirror_rows();
  for (const Row& row : scanned_mirror::gimbal_rows()) rows.push_back(row);
  return rows;
}

}  // namespace vectrix::validation

#include <memory>
#include <utility>
#include <vectrix/dynamics.hpp>
#include <vectrix/space/files/csv_table.hpp>

#include "comparison.hpp"
#include "difference.hpp"

namespace vectrix::validation {
namespace {

// The reference has 20 digits. The difference is the rounding of the integration in double precision, about
// 1e-16 per step over 1e3 steps.
constexpr double relative_tolerance = 1e-12;
// The effect, after 50 rad, of the rounding of initial state and moments to double.
constexpr double closed_form_tolerance = 1e-13;
constexpr const char* closed_form_reason = "reference of 20 digits; rounding of the given numbers";
constexpr const char* integration_reason = "reference of 20 digits; rounding of the integration";

struct Case {
  std::string name;
  Inertia<Body> inertia;
  State<Inertial, Body> start;
  double end;
};

Case read_case(const CsvTable& cases, std::size_t row) {
  const auto number = [&](const char* name) { return cases.number(row, name); };
  // HLW_GNI is a mathematical example, (2, 1, 2/3): its largest moment exceeds the sum of the other two. Only
  // the trusted door accepts it.
  Eigen::Matrix3d tensor;
  tensor << number("I11"), number("I12"), number("I13"), number("I12"), number("I22"), number("I23"),
      number("I13"), number("I23"), number("I33");
  return {.name = cases.text(row, "case"),
          .inertia = trust_inertia(in<Body>, tensor),
          .start = {.time = 0.0 * si::second,
                    .q_i_from_b = quaternion_scalar_first(to<Inertial>, from<Body>, number("q0"),
                                                          number("q1"), number("q2"), number("q3")),
                    .w_ib_b = angular_velocity(
                        of<Body>, relative_to<Inertial>,
                        vector<si::angular_velocity>(
                            in<Body>, Eigen::Vector3d(number("wx0"), number("wy0"), number("wz0"))))},
          .end = number("t_end")};
}

/// No door of a craft accepts the inertia of HLW_GNI, so that it replaces that of a ball inside.
Turning turning(const Inertia<Body>& J_b) {
  const auto unit = 1.0 * si::kilogram_square_metre;
  detail::CraftCore core =
      *craft_of(inertia_from_principal_moments(in<Body>, unit, unit, unit), turning_in<Inertial>).core();
  auto numbers = core.tree.numbers();
  numbers.hub.J = detail::symmetric(J_b.matrix());
  core.tree = multibody::Tree<double>(numbers);
  core.plain.J_c_h = J_b.matrix();
  return {detail::trusted, std::make_shared<const detail::CraftCore>(std::move(core))};
}

State<Inertial, Body> at(const TorqueFree<Inertial, Body>& motion, const Quantity<si::time>& t) {
  return motion.at(t);
}
State<Inertial, Body> at(const CraftTrajectory<Turning>& motion, const Quantity<si::time>& t) {
  const MovingDcm<Inertial, Body> now = motion(t);
  return {t, quaternion(now.rotation), now.angular_velocity};
}

// A motion, integrated or in closed form, at the time of one row of the reference.
void compare_row(Difference& difference, const CsvTable& exact, std::size_t row, const auto& motion) {
  const auto number = [&](const char* column) { return exact.number(row, column); };
  const State<Inertial, Body> state = at(motion, number("t_s") * si::second);
  difference.attitude(
      state.R_i_from_b(),
      Eigen::Quaterniond(number("q0"), number("q1"), number("q2"), number("q3")).toRotationMatrix());
  difference.rate(state.w_ib_b, {number("wx"), number("wy"), number("wz")});
}

template <class Motion>
void compare_rows(Difference& difference, const CsvTable& exact, const std::string& name,
                  const Motion& motion) {
  std::size_t compared = 0;
  for (std::size_t row = 0; row < exact.rows(); ++row) {
    if (exact.text(row, "case") != name) continue;
    compare_row(difference, exact, row, motion);
    ++compared;
  }
  if (compared == 0) throw std::runtime_error("no reference for " + name);
}

void compare(Rows& rows, const Case& given, const CsvTable& exact, AttitudeState attitude) {
  auto how = tight(given.end);
  how.attitude = attitude;
  const Turning craft = turning(given.inertia);
  const auto trajectory =
      propagate(scenario(craft), state(craft, given.start.time, moving(given.start)), how);
  Difference difference;
  compare_rows(difference, exact, given.name, trajectory);
  const std::string label =
      given.name + (attitude == AttitudeState::quaternion ? ", quaternion" : ", nine-element DCM");
  const double speed = given.start.w_ib_b.coordinates().norm();
  const CraftConservation kept = conservation(scenario(craft), trajectory);
  // The attitude error grows with the angle turned.
  const double turned = std::max(1.0, speed * given.end);
  rows.push_back({"Exact", label, "attitude per radian turned", relative_tolerance, "", integration_reason,
                  difference.attitude_rad / turned});
  rows.push_back({"Exact", label, "body rate, relative", relative_tolerance, "", integration_reason,
                  difference.rate_rad_s / speed});
  rows.push_back(
      {"Exact", label, "energy, relative change", relative_tolerance, "", "conserved", *kept.energy});
  rows.push_back({"Exact", label, "angular momentum, relative change", relative_tolerance, "", "conserved",
                  *kept.angular_momentum});
  rows.push_back({"Exact", label, "orthonormality drift", 10.0 * relative_tolerance, "",
                  "the attitude is never projected during the run", kept.orthonormality});
}

// The closed form, at every epoch of the reference; here the attitude error is not divided by the angle
// turned.
void compare_closed_form(Rows& rows, const Case& given, const CsvTable& exact) {
  const auto motion = torque_free(given.inertia, given.start);
  Difference difference;
  compare_rows(difference, exact, given.name, motion);
  const double speed = given.start.w_ib_b.coordinates().norm();
  rows.push_back({"Exact", given.name + ", closed form", "attitude", closed_form_tolerance, "rad",
                  closed_form_reason, difference.attitude_rad});
  rows.push_back({"Exact", given.name + ", closed form", "body rate, relative", closed_form_tolerance, "",
                  closed_form_reason, difference.rate_rad_s / speed});
}

}  // namespace

Rows exact_rows(const std::string& data) {
  const CsvTable cases =
      CsvTable::read(data + "/torque_free_cases.csv", {"case", "I11", "I22", "I33", "I12", "I13", "I23",
                                                       "wx0", "wy0", "wz0", "q0", "q1", "q2", "q3", "t_end"});
  const CsvTable exact = CsvTable::read(data + "/torque_free_exact.csv",
                                        {"case", "t_s", "wx", "wy", "wz", "q0", "q1", "q2", "q3"});
  Rows rows;
  for (std::size_t row = 0; row < cases.rows(); ++row) {
    for (const AttitudeState attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
      compare(rows, read_case(cases, row), exact, attitude);
    }
    compare_closed_form(rows, read_case(cases, row), exact);
  }
  return rows;
}

}  // namespace vectrix::validation

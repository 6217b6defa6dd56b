// Work-precision diagram of the integrators: the attitude error of a torque-free body in 20 s, about 22 rad,
// as a function of the number of rate evaluations. The exact motion is torque_free().
#include <algorithm>
#include <cmath>
#include <vectrix/dynamics.hpp>

#include "chart.hpp"
#include "pictures.hpp"

namespace pictures {
namespace {

using namespace vectrix;

struct Reference : inertial_frame {};
struct Body : moving_frame {};
using Rotation = Dcm<Reference, Body>;
using Time = Quantity<si::time>;

constexpr int seconds = 20;
const Eigen::Vector3d moments(1.0, 2.0, 3.0);     // kg m^2
const Eigen::Vector3d start_rate(0.7, 0.6, 0.6);  // rad/s

const Inertia<Body> J_b = [] {
  const auto moment = [](double value) { return Quantity<si::moment_of_inertia>::from_value(value); };
  return inertia_from_principal_moments(in<Body>, moment(moments(0)), moment(moments(1)), moment(moments(2)));
}();
const State<Reference, Body> start{
    0.0 * si::second, quaternion(aligned(to<Reference>, from<Body>)),
    angular_velocity(of<Body>, relative_to<Reference>, vector<si::angular_velocity>(in<Body>, start_rate))};
const TorqueFree<Reference, Body> exact = torque_free(J_b, start);

double angle_off(const Quaternion<Reference, Body>& q, double t) {
  return log(inverse(before(q)) * exact.at(t * si::second).q_i_from_b).angle().value();
}

/// The largest error at full seconds, as a function of the evaluations, for steps of `values` evaluations
/// each.
template <class Step> std::vector<Point> fixed_steps(int values, int fewest, int most, const Step& step) {
  std::vector<Point> points;
  for (int n = fewest; n <= most; n *= 2) {  // steps per second
    Rotation R = start.R_i_from_b();
    double worst = 0.0;
    for (int i = 0; i < seconds * n; ++i) {
      R = step(R, double(i) / n * si::second, 1.0 / n * si::second);
      if ((i + 1) % n == 0) worst = std::max(worst, angle_off(quaternion(R), (i + 1) / n));
    }
    points.push_back({double(values) * seconds * n, worst});
  }
  return points;
}

/// The rate follows from the attitude, as the momentum is fixed in space: w_ib^b = J^-1 R_i^b h^i.
AngularVelocity<Reference, Body, In<Body>> rate_of_attitude(const Time&, const Rotation& R_i_from_b) {
  static const auto h_i = start.R_i_from_b() * (J_b * start.w_ib_b);
  const auto h_b = inverse(R_i_from_b) * h_i;
  return angular_velocity(
      of<Body>, relative_to<Reference>,
      vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(h_b.coordinates().cwiseQuotient(moments))));
}

template <int Order> std::vector<Point> magnus(int fewest, int most) {
  const auto rate = [](const Time& t) { return exact.at(t).w_ib_b; };
  return fixed_steps(Order / 2, fewest, most, [&](const Rotation& R, const Time& t, const Time& dt) {
    return advance(R, magnus_increment<Order>(rate, t, dt));
  });
}
template <int Order> std::vector<Point> munthe_kaas(int fewest, int most) {
  return fixed_steps(Order == 4 ? 4 : 6, fewest, most, [](const Rotation& R, const Time& t, const Time& dt) {
    return munthe_kaas_step<Order>(rate_of_attitude, R, t, dt);
  });
}

std::vector<Point> propagated(ode::Method method, int digits) {
  const auto craft =
      spacecraft(body(mass_properties(1.0 * si::kilogram,
                                      coincident(of<CentreOfMassOf<Body>>, relative_to<Body>, in<Body>), J_b),
                      turning_in<Reference>));
  const auto from_start = state(craft, start.time, MovingDcm{start.R_i_from_b(), start.w_ib_b});
  std::vector<Point> points;
  for (int exponent = 3; exponent <= digits; ++exponent) {
    const double tolerance = std::pow(10.0, -exponent);
    CraftPropagation how{
        .end = double(seconds) * si::second,
        .relative_tolerance = tolerance,
        .absolute_tolerances = {tolerance * si::radian, tolerance * (si::radian / si::second),
                                1e-6 * si::metre, 1e-9 * (si::metre / si::second), 1e-12},
        .method = method};
    for (int t = 1; t <= seconds; ++t) how.output_times.push_back(double(t) * si::second);
    const auto trajectory = propagate(scenario(craft), from_start, how);
    double worst = 0.0;
    for (const auto& now : trajectory.outputs())
      worst = std::max(worst, angle_off(quaternion(now.turning().rotation), now.time().value()));
    points.push_back({double(trajectory.solution().statistics().rhs_evaluations), worst});
  }
  return points;
}

Axis error_axis() {
  return decades("largest error of the attitude in 20 s, rad", -12, 1, 2);
}
Axis work_axis(std::string label) {
  return decades(std::move(label), 1, 5);
}
void draw(Chart& chart, std::string_view words, const std::vector<Point>& points, const Stroke& stroke,
          const Point& moved = {7, 4}, std::string_view anchor = "start") {
  chart.curve(points, stroke);
  chart.label(points.back(), words, {stroke.colour, 12.0, anchor}, moved);
}

}  // namespace

std::string work_precision() {
  Svg svg(960, 500, "Work and precision of the integrators");
  Chart fixed(svg, {78, 40}, {468, 440}, "Attitude alone, fixed steps on the group",
              work_axis("values of the rate"), error_axis());
  draw(fixed, "Magnus 2", magnus<2>(1, 512), {colour::grey, 2.0, "6,4"});
  draw(fixed, "Magnus 4", magnus<4>(1, 128), {colour::blue, 2.0, "6,4"}, {-8, 8}, "end");
  draw(fixed, "Magnus 6", magnus<6>(1, 16), {colour::purple, 2.0, "6,4"}, {-8, 8}, "end");
  const auto commutator_free = fixed_steps(4, 1, 128, [](const Rotation& R, const Time& t, const Time& dt) {
    return commutator_free_step(rate_of_attitude, R, t, dt);
  });
  fixed.curve(commutator_free, {colour::green});
  fixed.label(commutator_free[5], "commutator-free 4", {colour::green, 12.0});
  draw(fixed, "Munthe-Kaas 4", munthe_kaas<4>(1, 128), {colour::orange}, {7, 8});
  draw(fixed, "Munthe-Kaas 5", munthe_kaas<5>(1, 64), {colour::brown}, {7, 6});
  fixed.label({1.3e1, 2e-9}, "dashed: the rate is", {colour::ink, 12.0}, {0, 0});
  fixed.label({1.3e1, 2e-9}, "known for all times", {colour::ink, 12.0}, {0, 16});

  Chart adaptive(svg, {552, 40}, {942, 440}, "Attitude and rate, with a tolerance",
                 work_axis("evaluations of the right-hand side"), error_axis());
  draw(adaptive, "BDF", propagated(ode::Method::cvode_bdf, 12), {colour::grey}, {-4, 18});
  draw(adaptive, "Adams", propagated(ode::Method::cvode_adams, 13), {colour::blue}, {-8, 4}, "end");
  draw(adaptive, "Fehlberg 7(8)", propagated(ode::Method::arkode_fehlberg_8, 11), {colour::purple}, {7, 12});
  draw(adaptive, "Verner 9(8)", propagated(ode::Method::verner_9, 11), {colour::green}, {-8, 4}, "end");
  draw(adaptive, "Verner 7(6)", propagated(ode::Method::verner_7, 11), {colour::orange}, {9, -8});
  draw(adaptive, "Dormand-Prince 5", propagated(ode::Method::arkode_dormand_prince_5, 11), {colour::brown},
       {7, -2});
  return svg.text();
}

}  // namespace pictures

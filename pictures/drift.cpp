// How the first-order step I + [w h]x departs from a rotation, for a body that spins at 1 rad/s.
#include <algorithm>
#include <cmath>
#include <vectrix/kinematics.hpp>

#include "chart.hpp"
#include "pictures.hpp"

namespace pictures {
namespace {

using namespace vectrix;

struct Reference : inertial_frame {};
struct Body : moving_frame {};

constexpr double duration = 10.0;  // s

AngularVelocity<Reference, Body, In<Body>> spin() {
  return angular_velocity(of<Body>, relative_to<Reference>,
                          vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(0.36, 0.48, 0.8)));
}

FirstOrderAttitude<Reference, Body> first_order(double h, int steps) {
  auto M = first_order_step(aligned(to<Reference>, from<Body>), spin(), h * si::second);
  for (int i = 1; i < steps; ++i) M = first_order_step(M, spin(), h * si::second);
  return M;
}
Eigen::Matrix3d exponential(double h, int steps) {
  Dcm<Reference, Body> R = aligned(to<Reference>, from<Body>);
  for (int i = 0; i < steps; ++i) R = exponential_step(R, spin(), h * si::second);
  return R.matrix();
}

}  // namespace

std::string drift() {
  Svg svg(960, 470, "The first-order step leaves the rotations");

  Chart volume(svg, {78, 40}, {468, 410}, "Determinant of the attitude matrix",
               steps("time, s", 0, 12.5, 2.5, 1), steps("determinant", 0.5, 3.0, 0.5, 1));
  std::vector<Point> kept;
  for (int i = 0; i <= 10; ++i) kept.push_back({double(i), exponential(0.1, 10 * i).determinant()});
  volume.curve(kept, {colour::blue}, false);
  volume.label(kept.back(), "exponential", {colour::blue, 12.0, "end"}, {0, 18});
  for (const double h : {0.1, 0.05, 0.02}) {
    std::vector<Point> grown{{0.0, 1.0}};
    for (int i = 1; i <= 10; ++i)
      grown.push_back({double(i), first_order(h, static_cast<int>(std::lround(i / h))).determinant()});
    volume.curve(grown, {colour::orange}, false);
    volume.label(grown.back(), "h = " + decimal(h, 2) + " s", {colour::orange, 12.0});
  }
  volume.label({5.0, 2.3}, "first order, 1 + |ωh|² a step", {colour::orange, 12.0, "middle"}, {-30, 0});

  // The exponential step departs by rounding only: values below the floor are drawn on the floor.
  constexpr double floor = 1e-12;
  std::vector<Point> departure, rounding;
  for (const double h : {1e-1, 5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3}) {
    const int steps = static_cast<int>(std::lround(duration / h));
    departure.push_back({h, first_order(h, steps).departure()});
    const Eigen::Matrix3d R = exponential(h, steps);
    rounding.push_back({h, std::max(floor, (R.transpose() * R - Eigen::Matrix3d::Identity()).norm())});
  }
  Chart departures(svg, {552, 40}, {932, 410}, "Departure from orthogonality after 10 s",
                   decades("step h, s", -3, -1), decades("|MᵀM − I|, Frobenius norm", -13, 1, 2));
  departures.curve(departure, {colour::orange});
  departures.label(departure[3], "first order, slope 1", {colour::orange, 12.0, "middle"}, {0, 26});
  departures.curve(rounding, {colour::blue});
  departures.label(rounding[3], "exponential, 10⁻¹² or less", {colour::blue, 12.0, "middle"}, {0, -10});
  return svg.text();
}

}  // namespace pictures

// The polhodes of a torque-free body: how its angular momentum H, fixed in space, moves in the body. |H| is
// constant, so H moves on a sphere, along lines of constant energy.
#include <array>
#include <cmath>
#include <numbers>
#include <vectrix/dynamics.hpp>

#include "pictures.hpp"
#include "svg.hpp"

namespace pictures {
namespace {

using namespace vectrix;
using Vector3 = Eigen::Vector3d;

struct Reference : inertial_frame {};
struct Body : moving_frame {};

// H^2 = 2 T J2, on the separatrix, where J1 (J2 - J1) w1^2 = J3 (J3 - J2) w3^2: here exactly w1 = 2 w3.
const Vector3 moments(3.0, 4.0, 6.0);  // kg m^2
constexpr double degree = std::numbers::pi / 180.0;

TorqueFree<Reference, Body> free_body(const Vector3& w) {
  const auto moment = [](double value) { return Quantity<si::moment_of_inertia>::from_value(value); };
  const auto J_b =
      inertia_from_principal_moments(in<Body>, moment(moments(0)), moment(moments(1)), moment(moments(2)));
  const State<Reference, Body> start{
      0.0 * si::second, quaternion_scalar_first(to<Reference>, from<Body>, 1.0, 0.0, 0.0, 0.0),
      angular_velocity(of<Body>, relative_to<Reference>, vector<si::angular_velocity>(in<Body>, w))};
  return torque_free(J_b, start);
}

/// The direction of H in the body.
Vector3 momentum(const TorqueFree<Reference, Body>& motion, double t) {
  const Vector3 w = motion.at(t * si::second).w_ib_b.coordinates();
  return moments.cwiseProduct(w).normalized();
}

/// Orthographic, seen from 55 degrees round from the first axis and 22 degrees up; the third axis points up.
class View {
 public:
  explicit View(const Point& centre, double radius) : centre_(centre), radius_(radius) {
    const double round = 55 * degree, up = 22 * degree;
    towards_ = {std::cos(up) * std::cos(round), std::cos(up) * std::sin(round), std::sin(up)};
    right_ = Vector3::UnitZ().cross(towards_).normalized();
    above_ = towards_.cross(right_);
  }
  Point at(const Vector3& r) const {
    return {centre_.x + radius_ * r.dot(right_), centre_.y - radius_ * r.dot(above_)};
  }
  bool in_front(const Vector3& r) const { return r.dot(towards_) >= 0.0; }

 private:
  Point centre_;
  double radius_;
  Vector3 towards_, right_, above_;
};

/// Draws the part of the curve in front of the sphere, or the part behind it, paler.
void draw(Svg& svg, const View& view, const std::vector<Vector3>& curve, const Stroke& front, bool behind) {
  std::vector<Point> piece;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (view.in_front(curve[i]) != behind) piece.push_back(view.at(curve[i]));
    const bool ends = i + 1 == curve.size() || view.in_front(curve[i + 1]) == behind;
    if (ends && piece.size() > 1) svg.line(piece, behind ? Stroke{front.colour, 0.6, "3,4"} : front);
    if (ends) piece.clear();
  }
}

/// An arrowhead at the middle of the front part.
void draw_arrow(Svg& svg, const View& view, const std::vector<Vector3>& curve, const Stroke& stroke) {
  std::vector<Vector3> front;
  for (const Vector3& place : curve) {
    if (view.in_front(place)) front.push_back(place);
  }
  if (front.size() < curve.size() / 4) return;
  double way = 0.0, half = 0.0;
  for (std::size_t i = 1; i < front.size(); ++i) half += (front[i] - front[i - 1]).norm() / 2;
  std::size_t middle = 0;
  while (way < half) {
    ++middle;
    way += (front[middle] - front[middle - 1]).norm();
  }
  const Point tip = view.at(front[middle]), tail = view.at(front[middle - 1]);
  const double length = std::hypot(tip.x - tail.x, tip.y - tail.y);
  const double x = 7 * (tip.x - tail.x) / length, y = 7 * (tip.y - tail.y) / length;
  svg.line({{tip.x - x - y / 2, tip.y - y + x / 2}, tip, {tip.x - x + y / 2, tip.y - y - x / 2}}, stroke);
}

struct Curve {
  std::vector<Vector3> places;
  Stroke stroke;
};

/// The curves through the great circle of the first and third axis.
std::vector<Curve> curves() {
  std::vector<Curve> list;
  const auto add = [&](const Vector3& w, double from, double to, int points, const Stroke& stroke) {
    const auto motion = free_body(w);
    Curve curve{{}, stroke};
    for (int i = 0; i <= points; ++i)
      curve.places.push_back(momentum(motion, from + (to - from) * i / points));
    list.push_back(std::move(curve));
  };
  for (const double angle : {9.0, 18.0, 27.0, 36.0, 54.0, 63.0, 72.0, 81.0}) {
    for (const double sign : {1.0, -1.0}) {
      const Vector3 H(std::cos(angle * degree), 0.0, std::sin(angle * degree));
      const Vector3 w = 6.0 * sign * H.cwiseQuotient(moments);
      const bool about_first = angle < 45.0;
      add(w, 0.0, free_body(w).period().value(), 144, {about_first ? colour::blue : colour::green, 1.5});
    }
  }
  for (const double first : {2.0, -2.0}) {
    for (const double third : {1.0, -1.0}) add({first, 0.0, third}, -15.0, 15.0, 200, {colour::orange, 2.6});
  }
  return list;
}

}  // namespace

std::string polhodes() {
  constexpr Point centre{370, 285};
  constexpr double radius = 210;
  Svg svg(770, 550, "Polhodes of a torque-free body");
  svg.text({centre.x, 24}, "Where the angular momentum goes in a body with moments 3, 4 and 6 kg m²",
           {colour::ink, 13.0, "middle", true});
  const View view(centre, radius);
  const auto all = curves();
  for (const Curve& curve : all) draw(svg, view, curve.places, curve.stroke, true);
  svg.disc(centre, radius, "none", {colour::grey, 1.0});
  for (const Curve& curve : all) {
    draw(svg, view, curve.places, curve.stroke, false);
    draw_arrow(svg, view, curve.places, curve.stroke);
  }

  struct Label {
    Vector3 axis;
    double length;
    std::string_view name, moment, anchor;
    Point moved;
  };
  const std::array labels{Label{{1, 0, 0}, 1.4, "axis 1", "smallest moment", "middle", {-20, 18}},
                          Label{{0, 1, 0}, 1.9, "axis 2", "intermediate moment", "start", {6, 0}},
                          Label{{0, 0, 1}, 1.2, "axis 3", "largest moment", "start", {8, 4}}};
  for (const Label& label : labels) {
    const Point foot = view.at(label.axis), end = view.at(label.length * label.axis);
    svg.line({foot, end}, {colour::ink, 1.5});
    svg.disc(foot, 3.5, colour::ink);
    const Point words{end.x + label.moved.x, end.y + label.moved.y};
    svg.text(words, label.name, {colour::ink, 13.0, label.anchor, true});
    svg.text({words.x, words.y + 16}, label.moment, {colour::ink, 12.0, label.anchor});
  }
  svg.text({centre.x - 178, centre.y - 130}, "separatrix", {colour::orange, 13.0, "end"});
  svg.text({centre.x - 205, centre.y - 72}, "about axis 1", {colour::blue, 13.0, "end"});
  svg.text({centre.x + 140, centre.y - 172}, "about axis 3", {colour::green, 13.0, "start"});
  return svg.text();
}

}  // namespace pictures

// Attitude errors after ten turns of the classical coning motion, as a function of the number of rate
// evaluations or angle counts.
#include <cmath>
#include <numbers>

#include "chart.hpp"
#include "pictures.hpp"
#include "testing/coning_motion.hpp"

namespace pictures {
namespace {

using namespace vectrix;

struct Reference : inertial_frame {};
struct Body : moving_frame {};

constexpr int turns = 10;
const vectrix_test::ConingMotion<Reference, Body> motion{0.1, 2 * std::numbers::pi};  // one turn per second
const std::vector<int> counts_a_turn{6, 12, 24, 48, 96, 192, 384};

/// The error of increment(t, h), the increment of a step of `parts` counts of length h each.
template <class IncrementOf>
std::vector<Point> errors(int parts, int fewest, int most, const IncrementOf& increment) {
  std::vector<Point> points;
  for (const int n : counts_a_turn) {
    if (n < fewest || n > most) continue;
    const double h = 1.0 / n;
    Quaternion<Reference, Body> q = motion.attitude(0.0);
    for (int i = 0; i < turns * n; i += parts) q = advance(q, increment(i * h, h));
    points.push_back({double(n), log(inverse(before(q)) * motion.attitude(turns)).angle().value()});
  }
  return points;
}

template <int Order> std::vector<Point> magnus(int most) {
  const auto rate = [](const Quantity<si::time>& t) { return motion.rate(t.value()); };
  constexpr int values = Order / 2;
  return errors(values, 6, most, [&](double t, double h) {
    return magnus_increment<Order>(rate, t * si::second, values * h * si::second);
  });
}

/// The order of the error in the interval, up to the given point.
std::string slope(const std::vector<Point>& points, std::size_t end) {
  const Point &a = points[end - 1], &b = points[end];
  return "slope " + decimal(std::log(a.y / b.y) / std::log(b.x / a.x), 1);
}

Axis error_axis() {
  return decades("error after 10 turns of the cone, rad", -13, 0, 2);
}
Axis count_axis(std::string label) {
  Axis axis{std::move(label), 5.0, 4000.0, true, {}};
  for (const int n : counts_a_turn) axis.ticks.emplace_back(n, std::to_string(n));
  return axis;
}

void draw(Chart& chart, std::string_view words, const std::vector<Point>& points, std::string_view ink,
          std::string_view dashes = "", const Point& moved = {7, 4}) {
  chart.curve(points, {ink, 2.0, dashes});
  chart.label(points.back(), std::string(words) + ", " + slope(points, points.size() - 1), {ink, 12.0},
              moved);
}

}  // namespace

std::string coning() {
  const auto integral = errors(1, 6, 384, [](double t, double h) {
    return rotation_vector(of<Body>, relative_to<Before<Reference, Body>>, motion.count(t, h).vector());
  });
  const auto after = errors(1, 6, 384, [](double t, double h) {
    return coning_corrected_after(motion.count(t - h, h), motion.count(t, h));
  });
  const auto two = errors(2, 6, 384, [](double t, double h) {
    return coning_corrected(motion.count(t, h), motion.count(t + h, h));
  });
  const auto three = errors(3, 6, 384, [](double t, double h) {
    return coning_corrected(motion.count(t, h), motion.count(t + h, h), motion.count(t + 2 * h, h));
  });

  Svg svg(960, 470, "Error of the increments of a coning motion");
  Chart rates(svg, {78, 40}, {468, 410}, "Rates: Magnus increments",
              count_axis("values of the rate in a turn"), error_axis());
  draw(rates, "exp of ∫ω", integral, colour::orange, "6,4", {7, -4});
  draw(rates, "order 2", magnus<2>(384), colour::blue, "", {7, 10});
  draw(rates, "order 4", magnus<4>(384), colour::green);
  draw(rates, "order 6", magnus<6>(192), colour::purple);

  Chart counts(svg, {552, 40}, {942, 410}, "Counts: coning corrections",
               count_axis("counts of the angle in a turn"), error_axis());
  draw(counts, "exp of ∫ω", integral, colour::orange, "6,4");
  draw(counts, "pairs", two, colour::green);
  counts.curve(after, {colour::blue, 2.0, "3,5"}, false);
  counts.label(after[3], "each with the one before", {colour::blue, 12.0}, {10, -1});
  draw(counts, "threes", three, colour::purple);
  counts.label(three[2], slope(three, 2), {colour::purple, 12.0, "end"}, {-7, 16});
  return svg.text();
}

}  // namespace pictures

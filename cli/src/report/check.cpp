#include "report/check.hpp"

#include <cmath>
#include <string>

namespace vectrix::cli {
namespace {

// Curves are stored with 24 bits of 8-bit exponents.
constexpr double largest_value = 1e37;
// Of directions and quaternions, as a file of single precision has them.
constexpr double unit_tolerance = 1e-6;

std::string numbered(const std::string& what, std::size_t place) {
  return what + ": number " + detail::text(place + 1);
}

void require_times(const std::string& what, const std::vector<double>& seconds) {
  if (seconds.empty()) throw BadInput(what + " has no times");
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    if (!std::isfinite(seconds[i]))
      throw BadInput(numbered(what, i) + " of the times is " + detail::text(seconds[i]));
    if (i > 0 && !(seconds[i] > seconds[i - 1]))
      throw BadInput(numbered(what, i) + " of the times is " + detail::text(seconds[i]) + " s after " +
                     detail::text(seconds[i - 1]) + " s; times have to increase");
  }
}

void require_as_many(const std::string& what, std::size_t values, std::size_t times) {
  if (values != times)
    throw BadInput(what + " has " + detail::text(values) + " values for " + detail::text(times) + " times");
}

void require_curve(const std::string& what, const Report::Curve& curve, std::size_t times) {
  require_as_many(what, curve.values.size(), times);
  for (std::size_t i = 0; i < curve.values.size(); ++i)
    if (std::abs(curve.values[i]) > largest_value)
      throw BadInput(numbered(what, i) + " is " + detail::text(curve.values[i]) + "; at most " +
                     detail::text(largest_value) + " can be shown");
}

void require_plot(const Report::Plot& plot) {
  const std::string what = "plot '" + plot.title + "'";
  require_times(what, plot.seconds);
  if (plot.curves.empty()) throw BadInput(what + " has no curve");
  for (const auto& curve : plot.curves)
    require_curve(what + ", curve '" + curve.name + "'", curve, plot.seconds.size());
  for (const auto& limit : plot.limits)
    if (!(std::abs(limit.value) <= largest_value))
      throw BadInput(what + ", limit '" + limit.name + "' is " + detail::text(limit.value));
}

template <class Vector> void require_unit(const std::string& what, const Vector& v) {
  const double norm = v.norm();
  if (!(std::abs(norm - 1.0) <= unit_tolerance))
    throw BadInput(what + " has the norm " + detail::text(norm) + ", not 1");
}
template <class Vector> bool is_gap(const Vector& v) {
  return v.array().isNaN().all();
}

void require_units(const std::string& what, const std::vector<Eigen::Quaterniond>& all, std::size_t times) {
  require_as_many(what, all.size(), times);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!is_gap(all[i].coeffs())) require_unit(numbered(what, i), all[i].coeffs());
}

template <class Vector>
void require_numbers(const std::string& what, const std::vector<Vector>& all, std::size_t times) {
  if (all.empty()) return;
  require_as_many(what, all.size(), times);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!all[i].allFinite() && !is_gap(all[i])) throw BadInput(numbered(what, i) + " is not finite");
}

void require_track(const std::vector<Eigen::Vector2d>& track, std::size_t times) {
  const std::string what = "ground track";
  require_numbers(what, track, times);
  for (std::size_t i = 0; i < track.size(); ++i)
    if (std::abs(track[i].x()) > 90.0 || std::abs(track[i].y()) > 180.0)
      throw BadInput(numbered(what, i) + " has latitude " + detail::text(track[i].x()) + " and longitude " +
                     detail::text(track[i].y()) + " deg; they are within 90 and 180");
}

void require_scene(const Report::Scene& scene) {
  const std::size_t times = scene.seconds.size();
  require_times("the scene", scene.seconds);
  require_units("attitude of " + scene.body, scene.reference_from_body, times);
  for (const auto& frame : scene.frames)
    require_unit("frame '" + frame.name + "' of the body", frame.body_from_frame.coeffs());
  for (const auto& axis : scene.axes) require_unit("axis '" + axis.name + "' of the body", axis.axis);
  for (const auto& direction : scene.directions) {
    const std::string what = "direction '" + direction.name + "'";
    require_as_many(what, direction.vectors.size(), times);
    for (std::size_t i = 0; i < times; ++i)
      if (!is_gap(direction.vectors[i])) require_unit(numbered(what, i), direction.vectors[i]);
  }
  for (const auto& view : scene.views) require_units("view '" + view.name + "'", view.from_reference, times);
  require_numbers("positions", scene.positions, times);
  require_track(scene.ground_track, times);
}

}  // namespace

void require_consistent(const Report& report) {
  for (const auto& plot : report.plots) require_plot(plot);
  for (const auto& table : report.tables)
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      if (table.rows[i].size() != table.headings.size())
        throw BadInput("table '" + table.title + "': row " + detail::text(i + 1) + " has " +
                       detail::text(table.rows[i].size()) + " texts for " +
                       detail::text(table.headings.size()) + " headings");
  if (report.scene) require_scene(*report.scene);
}

}  // namespace vectrix::cli

#include <vectrix/space/fields/gravity_field.hpp>

#include <vectrix/frames/errors.hpp>

#include "gravity_model.hpp"
#include "harmonic_series.hpp"

namespace vectrix {
namespace {

using detail::text;

constexpr double smallest_distance_in_radii = 0.98;  // of the radius; the poles are at 0.9966

std::array<detail::Harmonics, 3> gradient_of(const detail::Harmonics& potential) {
  return {derivative(potential, 0), derivative(potential, 1), derivative(potential, 2)};
}

// Of the same degree as the second derivatives.
detail::Harmonics raised(const detail::Harmonics& harmonics) {
  detail::Harmonics result(harmonics.degree() + 1);
  for (int n = 0; n <= harmonics.degree(); ++n) {
    for (int m = 0; m <= n; ++m) result.add(n, m, harmonics.at(n, m));
  }
  return result;
}

}  // namespace

// The central term is written out: the series is a thousandth of it, and so is its rounding.
struct GravityField::Series {
  double mu, radius;
  int degree;
  detail::HarmonicSeries<3> acceleration;
  detail::HarmonicSeries<8> with_gradient;  // gx, gy, gz, Gxx, Gxy, Gxz, Gyy, Gyz

  explicit Series(const detail::GravityModel& model)
      : Series(model, gradient_of(without_centre(model.coefficients))) {}

  [[nodiscard]] double distance(const Eigen::Vector3d& r) const {
    const double found = r.norm();
    if (!(found >= smallest_distance_in_radii * radius)) {
      throw BadInput("GravityField: the point is " + text(found) + " m from the centre, inside " +
                     text(smallest_distance_in_radii) + " of the radius " + text(radius) + " m");
    }
    return found;
  }

 private:
  Series(const detail::GravityModel& model, const std::array<detail::Harmonics, 3>& g)
      : mu(model.mu * model.coefficients.at(0, 0).C),
        radius(model.radius),
        degree(model.coefficients.degree()),
        acceleration(g, model.radius),
        with_gradient({raised(g[0]), raised(g[1]), raised(g[2]), derivative(g[0], 0), derivative(g[0], 1),
                       derivative(g[0], 2), derivative(g[1], 1), derivative(g[1], 2)},
                      model.radius) {}

  static detail::Harmonics without_centre(const detail::Harmonics& normalized) {
    detail::Harmonics rest = harmonics_of(normalized, detail::Harmonics::Normalization::full);
    rest.add(0, 0, {-rest.at(0, 0).C, 0.0});
    return rest;
  }
};

GravityField GravityField::egm2008(int degree) {
  if (degree < 0 || degree > detail::egm2008_degree) {
    throw BadInput("GravityField::egm2008: the degree is " + text(degree) + "; 0 to " +
                   text(detail::egm2008_degree) + " are built in, read() takes higher ones from a file");
  }
  return GravityField{std::make_shared<const Series>(detail::egm2008_model(degree))};
}

GravityField GravityField::read(const std::filesystem::path& gfc, int degree) {
  return GravityField{std::make_shared<const Series>(detail::read_icgem(gfc, degree))};
}

int GravityField::degree() const {
  return series_->degree;
}
Quantity<si::gravitational_parameter> GravityField::mu() const {
  return Quantity<si::gravitational_parameter>::from_value(series_->mu);
}
Quantity<si::length> GravityField::radius() const {
  return series_->radius * si::metre;
}

Vector<earth::Itrf, si::acceleration> GravityField::acceleration(const earth::PositionInItrf& r_itrf) const {
  const Eigen::Vector3d& r = r_itrf.coordinates();
  const double distance = series_->distance(r);
  const auto rest = series_->acceleration.at(r);
  const double scale = series_->mu / (series_->radius * series_->radius);
  return {detail::trusted, scale * Eigen::Vector3d(rest[0], rest[1], rest[2]) -
                               series_->mu / (distance * distance * distance) * r};
}

GravityField::WithGradient GravityField::with_gradient(const earth::PositionInItrf& r_itrf) const {
  const Eigen::Vector3d& r = r_itrf.coordinates();
  const double distance = series_->distance(r);
  const auto rest = series_->with_gradient.at(r);
  const double scale = series_->mu / (series_->radius * series_->radius);
  const double central = series_->mu / (distance * distance * distance);
  const Eigen::Vector3d up = r / distance;
  Eigen::Matrix3d tensor;
  tensor << rest[3], rest[4], rest[5], rest[4], rest[6], rest[7], rest[5], rest[7], -rest[3] - rest[6];
  return {{detail::trusted, scale * Eigen::Vector3d(rest[0], rest[1], rest[2]) - central * r},
          {detail::trusted, scale / series_->radius * tensor +
                                central * (3.0 * up * up.transpose() - Eigen::Matrix3d::Identity())}};
}

}  // namespace vectrix

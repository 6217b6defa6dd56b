#include <vectrix/space/fields/magnetic_field.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "harmonic_series.hpp"
#include "magnetic_model.hpp"

namespace vectrix {
namespace {

using detail::Harmonics;
using detail::text;

constexpr double reference_radius = 6371.2e3;  // m, of both models
constexpr double smallest_distance = 6200e3;   // m
constexpr double tesla_in_nanotesla = 1e-9;

Epoch start_of(int year) {
  return Epoch::from_tt(text(year) + "-01-01T00:00:00");
}

// Three sums for the field at the start of a span, three for its change until the end.
detail::HarmonicSeries<6> series_of(const Harmonics& start, const Harmonics& end) {
  Harmonics change(start.degree());
  for (int n = 1; n <= start.degree(); ++n) {
    for (int m = 0; m <= n; ++m)
      change.add(n, m, {end.at(n, m).C - start.at(n, m).C, end.at(n, m).S - start.at(n, m).S});
  }
  const Harmonics field = harmonics_of(start, Harmonics::Normalization::schmidt);
  const Harmonics rate = harmonics_of(change, Harmonics::Normalization::schmidt);
  return {{derivative(field, 0), derivative(field, 1), derivative(field, 2), derivative(rate, 0),
           derivative(rate, 1), derivative(rate, 2)},
          reference_radius};
}

}  // namespace

struct MagneticField::Series {
  std::string name;
  std::vector<Epoch> years;  // the start of each year, and of the year after the last
  std::vector<int> spans;    // the years in which the spans start, counted from the first, and the end
  std::vector<detail::HarmonicSeries<6>> fields;

  explicit Series(const detail::MagneticModel& model) : name(model.name) {
    const int first = model.epochs.front().year;
    for (int year = first; year <= model.epochs.back().year; ++year) years.push_back(start_of(year));
    for (const auto& at_year : model.epochs) spans.push_back(at_year.year - first);
    for (std::size_t i = 0; i + 1 < model.epochs.size(); ++i)
      fields.push_back(series_of(model.epochs[i].potential, model.epochs[i + 1].potential));
  }

  // Years and parts of a year since the first, and the length of the year, s.
  [[nodiscard]] std::pair<double, double> years_until(const Epoch& epoch) const {
    if (!(epoch >= years.front() && epoch <= years.back())) {
      throw BadInput("MagneticField " + name + ": the epoch " + epoch.tt() + " TT is outside the model, " +
                     years.front().tt(0) + " to " + years.back().tt(0) + " TT");
    }
    const auto next = std::min(std::ranges::upper_bound(years, epoch), std::prev(years.end()));
    const auto start = std::prev(next);
    const auto year = *next - *start;
    return {static_cast<double>(start - years.begin()) + (epoch - *start) / year, year.value()};
  }
};

MagneticField MagneticField::igrf14() {
  return MagneticField{std::make_shared<const Series>(detail::igrf14_model())};
}
MagneticField MagneticField::wmm2025() {
  return MagneticField{std::make_shared<const Series>(detail::wmm2025_model())};
}

const Epoch& MagneticField::first() const {
  return series_->years.front();
}
const Epoch& MagneticField::last() const {
  return series_->years.back();
}

MagneticField::WithRate MagneticField::with_rate(const earth::PositionInItrf& r_itrf,
                                                 const Epoch& epoch) const {
  const Eigen::Vector3d& r = r_itrf.coordinates();
  if (!(r.norm() >= smallest_distance)) {
    throw BadInput("MagneticField " + series_->name + ": the point is " + text(r.norm()) +
                   " m from the centre; the series holds outside the Earth");
  }
  const auto [years, of_a_year] = series_->years_until(epoch);
  const auto& spans = series_->spans;
  const auto next = std::min(std::ranges::upper_bound(spans, years), std::prev(spans.end()));
  const auto span = static_cast<std::size_t>(next - spans.begin()) - 1;
  const double length = spans[span + 1] - spans[span];
  const auto sums = series_->fields[span].at(r);
  const Eigen::Vector3d start(sums[0], sums[1], sums[2]), change(sums[3], sums[4], sums[5]);
  using Rate = Derivative<earth::Itrf, earth::Itrf, si::magnetic_flux_density>;
  return {{detail::trusted, -tesla_in_nanotesla * (start + (years - spans[span]) / length * change)},
          Rate{detail::trusted, Vector<earth::Itrf, Rate::unit>{
                                    detail::trusted, -tesla_in_nanotesla / (length * of_a_year) * change}}};
}

Vector<earth::Itrf, si::magnetic_flux_density> MagneticField::at(const earth::PositionInItrf& r_itrf,
                                                                 const Epoch& epoch) const {
  return with_rate(r_itrf, epoch).field;
}

}  // namespace vectrix

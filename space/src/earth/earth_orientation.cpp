#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/earth/intermediate_frames.hpp>

#include "../time/date.hpp"
#include "erfa_rotation.hpp"
#include "finals2000a.hpp"
#include "ocean_tides.hpp"
#include "row_spline.hpp"

namespace vectrix {

MovingDcm<earth::Gcrf, earth::Itrf> earth_rotation(const Epoch& epoch,
                                                   const EarthOrientationParameters& parameters) {
  return gcrf_from_cirf(epoch, parameters) * cirf_from_tirf(epoch, parameters) *
         tirf_from_itrf(epoch, parameters);
}

EarthOrientation::EarthOrientation(std::vector<Epoch> epochs, std::vector<EarthOrientationParameters> rows,
                                   bool is_observed) {
  detail::set_rates(epochs, rows);
  data_ = std::make_shared<const Data>(Data{std::move(epochs), std::move(rows), is_observed});
}

EarthOrientation EarthOrientation::read(const std::filesystem::path& finals2000A) {
  return of_file(finals2000A, false);
}

EarthOrientation EarthOrientation::read(const std::filesystem::path& finals2000A, OffsetsFromIau2006) {
  return of_file(finals2000A, true);
}

EarthOrientation EarthOrientation::of_file(const std::filesystem::path& finals2000A,
                                           bool offsets_are_from_iau_2006) {
  auto [epochs, rows] = detail::read_finals2000A(finals2000A, offsets_are_from_iau_2006);
  return {std::move(epochs), std::move(rows), true};
}

EarthOrientation EarthOrientation::unobserved(const TimeSpan& span, const Quantity<si::time>& ut1_minus_utc) {
  if (!(std::abs(ut1_minus_utc.value()) <= detail::largest_ut1_minus_utc)) {
    throw BadInput("EarthOrientation::unobserved: UT1-UTC is " + detail::text(ut1_minus_utc.value()) +
                   " s; UTC keeps it within 0.9 s");
  }
  constexpr double longest = 100.0 * 365.25 * 86400.0;  // s
  const double length = (span.end() - span.start()).value();
  if (length > longest) {
    throw BadInput("EarthOrientation::unobserved: the span has " + detail::text(length) +
                   " s; at most 100 years are allowed");
  }
  constexpr int steps = 3;  // four rows, as a spline needs
  const auto step = length / steps * si::second;
  if (!(step.value() > 0.0)) {
    throw BadInput("EarthOrientation::unobserved: the span at " + detail::shown(span.start()) +
                   " has no duration");
  }
  EarthOrientationParameters row{};
  row.ut1_minus_tai = ut1_minus_utc - span.start().tai_minus_utc();
  std::vector<Epoch> epochs;
  for (int i = 0; i < steps; ++i) epochs.push_back(span.start() + static_cast<double>(i) * step);
  epochs.push_back(span.end());
  return {std::move(epochs), std::vector<EarthOrientationParameters>(steps + 1, row), false};
}

void EarthOrientation::require(const Epoch& epoch) const {
  if (epoch < first() || epoch > last()) {
    detail::refuse_outside("EarthOrientation", epoch, "the data, which span", from_until(first(), last()));
  }
}

Eigen::Matrix<double, 5, 3> EarthOrientation::curves(const Epoch& epoch) const {
  const auto& epochs = data_->epochs;
  const auto& rows = data_->rows;
  const auto after = std::upper_bound(epochs.begin() + 1, epochs.end() - 1, epoch) - epochs.begin();
  const auto right = static_cast<std::size_t>(after);
  const std::size_t left = right - 1;
  return detail::cubic(rows[left], rows[right], epochs[right] - epochs[left], epoch - epochs[left]);
}

EarthOrientationParameters EarthOrientation::parameters(const Epoch& epoch) const {
  require(epoch);
  const auto c = curves(epoch);
  const auto angle = [&](Eigen::Index row) { return c(row, 0) * si::radian; };
  const auto rate = [&](Eigen::Index row) { return c(row, 1) * (si::radian / si::second); };
  return {angle(0),
          angle(1),
          c(2, 0) * si::second,
          Quantity<si::dimensionless>{c(2, 1)},
          angle(3),
          angle(4),
          rate(0),
          rate(1),
          rate(3),
          rate(4)};
}

EarthOrientationParameters EarthOrientation::parameters(const Epoch& epoch, SubdailyTides) const {
  EarthOrientationParameters p = parameters(epoch);
  const Eigen::Matrix3d tides = detail::ocean_tides(epoch, p.ut1_minus_tai);
  p.pole_x = p.pole_x + tides(0, 0) * si::radian;
  p.pole_y = p.pole_y + tides(1, 0) * si::radian;
  p.ut1_minus_tai = p.ut1_minus_tai + tides(2, 0) * si::second;
  p.pole_x_rate = p.pole_x_rate + tides(0, 1) * (si::radian / si::second);
  p.pole_y_rate = p.pole_y_rate + tides(1, 1) * (si::radian / si::second);
  p.ut1_gain = p.ut1_gain + Quantity<si::dimensionless>{tides(2, 1)};
  return p;
}

MovingDcm<earth::Gcrf, earth::Itrf> EarthOrientation::at(const Epoch& epoch) const {
  const auto p = parameters(epoch);
  const auto kept = data_->is_observed ? detail::Ut1Kept::no : detail::Ut1Kept::over_a_leap_second;
  return gcrf_from_cirf(epoch, p) * detail::cirf_from_tirf(epoch, p, kept) * tirf_from_itrf(epoch, p);
}

}  // namespace vectrix

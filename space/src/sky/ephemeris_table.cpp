#include <string>
#include <utility>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/sky/aberration.hpp>
#include <vectrix/space/sky/ephemeris_table.hpp>

#include "series.hpp"

namespace vectrix::detail {
namespace {

// The pieces begin earlier than the span by the longest light time.
Quantity<si::time> longest_light_time(Body body) {
  return (body == Body::sun || body == Body::moon ? 1e3 : 2e4) * si::second;
}

ChebyshevPieces pieces_of(Body body, const TimeSpan& span) {
  const int days = body == Body::moon ? 4 : 16;
  const int coefficients = body == Body::moon ? 12 : body == Body::sun ? 14 : 16;
  return {series_of(body).motion, days, coefficients, span.start() - longest_light_time(body), span.end()};
}

const TimeSpan& within_series(const std::string& name, const TimeSpan& span) {
  for (const Epoch& end : {span.start(), span.end()}) require_series([&] { return name; }, end);
  return span;
}

}  // namespace

EphemerisTable::EphemerisTable(Body body, const TimeSpan& span)
    : EphemerisTable(std::string{"Ephemeris<"} + series_of(body).name + ">", body, span) {}

EphemerisTable::EphemerisTable(std::string name, Body body, const TimeSpan& span)
    : name_(std::move(name)),
      body_(body),
      span_(within_series(name_, span)),
      body_pieces_(pieces_of(body, span)),
      earth_pieces_(earth_motion, 16, 14, span.start() - longest_light_time(body), span.end()) {}

void EphemerisTable::require(const Epoch& epoch) const {
  if (!span_.contains(epoch)) [[unlikely]]
    refuse_outside(name_, epoch, "the span,", span_);
}

PlainMotion EphemerisTable::motion(const Epoch& epoch) const {
  require(epoch);
  return body_pieces_.at(epoch.tai());
}

PlainMotion EphemerisTable::earth(const Epoch& epoch) const {
  require(epoch);
  return earth_pieces_.at(epoch.tai());
}

Eigen::Vector3d EphemerisTable::line(Geometric, const Epoch& epoch, const Eigen::Vector3d& r) const {
  return motion(epoch).position - r;
}

Eigen::Vector3d EphemerisTable::line(LightTime, const Epoch& epoch, const Eigen::Vector3d& r) const {
  return line(epoch, r, earth(epoch));
}

Eigen::Vector3d EphemerisTable::line(Apparent, const Epoch& epoch, const Eigen::Vector3d& r,
                                     const Eigen::Vector3d& v) const {
  const PlainMotion now = earth(epoch);
  const Eigen::Vector3d d = line(epoch, r, now);
  const double distance = d.norm();
  return distance * aberrated(d / distance, now.velocity + v);
}

Eigen::Vector3d EphemerisTable::line(const Epoch& epoch, const Eigen::Vector3d& r,
                                     const PlainMotion& earth_now) const {
  const double c = speed_of_light.value();
  const double first = (body_pieces_.at(epoch.tai()).position - r).norm() / c;
  const double longest = longest_light_time(body_).value();
  if (!(first <= longest)) {
    throw BadInput(name_ + ": the light takes " + text(first) + " s to the observer; at most " +
                   text(longest) + " s are allowed");
  }
  const Epoch left = epoch - first * si::second;
  const PlainMotion body = body_pieces_.at(left.tai());
  const PlainMotion earth_then = earth_pieces_.at(left.tai());
  const Eigen::Vector3d velocity = earth_then.velocity + body.velocity;
  const Eigen::Vector3d at_first = (earth_then.position - earth_now.position) + body.position - r;
  // Each iteration reduces the error of the light time by v/c, 1e-4; the velocity is constant meanwhile.
  Eigen::Vector3d d = at_first;
  for (int i = 0; i < 3; ++i) d = at_first - (d.norm() / c - first) * velocity;
  return d;
}

}  // namespace vectrix::detail

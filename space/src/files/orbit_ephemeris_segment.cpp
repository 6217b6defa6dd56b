#include <vectrix/space/files/orbit_ephemeris_segment.hpp>

#include <cmath>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "ephemeris_rules.hpp"
#include "frame_claim.hpp"
#include "kvn.hpp"
#include "orbit_ephemeris_text.hpp"
#include "text_file.hpp"

namespace vectrix {
namespace {

std::string place_of(const EphemerisMetadata& metadata) {
  return "orbit ephemeris segment of '" + detail::excerpt(metadata.object_name) + "'";
}

std::vector<Epoch> times_of(const std::string& place, const std::vector<detail::OrbitLine>& lines) {
  std::vector<Epoch> times;
  times.reserve(lines.size());
  for (const detail::OrbitLine& line : lines) {
    times.push_back(line.time);
    for (const Eigen::Vector3d* v : {&line.position, &line.velocity}) {
      for (const double number : *v) {
        if (!std::isfinite(number))
          throw BadInput(place + ": sample " + detail::text(times.size() - 1) + " has the number " +
                         detail::text(number));
      }
    }
  }
  return times;
}

}  // namespace

void detail::UseableSpan::refuse(const Epoch& t) const {
  const auto shown = [](const std::optional<Epoch>& time) { return time ? instant_text(*time) : "..."; };
  throw BadInput(place + ": the time " + instant_text(t) + " is outside the useable times, [" + shown(start) +
                 ", " + shown(stop) + "]");
}

OrbitEphemerisSegment::OrbitEphemerisSegment(detail::Trusted, EphemerisMetadata metadata,
                                             detail::OrbitLines lines)
    : metadata_(std::move(metadata)), lines_(std::move(lines)) {}

OrbitEphemerisSegment::OrbitEphemerisSegment(detail::Trusted, EphemerisMetadata metadata,
                                             std::vector<detail::OrbitLine> lines,
                                             const detail::FrameClaim& claim)
    : metadata_(std::move(metadata)),
      lines_{place_of(metadata_), detail::name_of(claim), std::nullopt, std::move(lines), {}, {}} {
  if (metadata_.center_name.empty()) metadata_.center_name = claim.center;
  detail::require_text(lines_.place, "REF_FRAME", lines_.ref_frame);
  metadata_ = detail::checked_metadata(lines_.place, detail::orbit_ephemeris, std::move(metadata_),
                                       times_of(lines_.place, lines_.lines));
  require_frame(claim);
}

void OrbitEphemerisSegment::require_frame(const detail::FrameClaim& claim) const {
  detail::require_named(lines_.place, "REF_FRAME", ref_frame(), claim);
  if (detail::upper_case(metadata_.center_name) != detail::upper_case(claim.center))
    throw BadInput(lines_.place + ": CENTER_NAME is '" + detail::excerpt(metadata_.center_name) +
                   "'; the centre of " + detail::shown(claim) + " is '" + detail::excerpt(claim.center) +
                   "'");
  if (ref_frame_epoch() && detail::is_of_date(claim.standard))
    throw BadInput(lines_.place + ": REF_FRAME_EPOCH stops " + ref_frame() + " at " +
                   exact_text(*ref_frame_epoch(), metadata_.time_system) + ", so that it is not " +
                   claim.type);
}

void OrbitEphemerisSegment::require_accelerations() const {
  for (const detail::OrbitLine& line : lines_.lines) {
    if (!line.acceleration)
      throw BadInput(lines_.place + ": the line of " + exact_text(line.time, metadata_.time_system) +
                     " has no acceleration");
  }
}

bool OrbitEphemerisSegment::is_hermite() const {
  const std::string method = detail::upper_case(metadata_.interpolation);
  if (method != "LAGRANGE" && method != "HERMITE")
    throw BadInput(
        lines_.place + ": INTERPOLATION is '" + detail::excerpt(metadata_.interpolation) +
        "'; an edge has LAGRANGE or HERMITE, or what you choose: sampled_edge(segment.samples(...), "
        "Lagrange{7}, longest_gap)");
  return method == "HERMITE";
}

int OrbitEphemerisSegment::interpolation_degree() const {
  if (!metadata_.interpolation_degree) throw BadInput(lines_.place + ": there is no INTERPOLATION_DEGREE");
  return *metadata_.interpolation_degree;
}

detail::UseableSpan OrbitEphemerisSegment::useable() const {
  return {lines_.place, metadata_.useable_start_time, metadata_.useable_stop_time};
}

}  // namespace vectrix

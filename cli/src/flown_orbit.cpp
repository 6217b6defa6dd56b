#include "flown_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "attitude_record.hpp"
#include "figures.hpp"
#include "message_kind.hpp"
#include "plain_words.hpp"
#include "selection.hpp"
#include "table_text.hpp"

namespace vectrix::cli {
namespace {

using earth::Eme2000, earth::Gcrf, earth::Itrf, earth::Teme;

template <class... Edges> FlownOrbit flown(const Edges&... edges) {
  const auto graph = std::make_shared<const FrameGraph<Edges...>>(frame_graph(edges...));
  return [graph](const Epoch& t) -> PointMotion<Gcrf, Satellite, Gcrf> {
    const auto now = graph->at(t);
    return {now.position(of<Satellite>, relative_to<Gcrf>, in<Gcrf>),
            now.velocity(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>)};
  };
}

// From Teme to Gcrf over Itrf: the turn of the Earth cancels, so that nothing observed is needed but dX, dY,
// 1e-9 rad.
template <class Orbit> FlownOrbit flown_in_teme(const TimeSpan& span, const Orbit& orbit) {
  const EarthMotion earth(EarthOrientation::unobserved(span, 0.0 * si::second), span);
  return flown(edge(earth), edge(teme(earth)), orbit);
}

constexpr double longest_gap = 3600.0, longest_age = 7.0 * 86400.0;  // s

// What the segment says, or nothing if no edge can be made of it.
std::optional<Interpolation> said_by(const EphemerisMetadata& metadata) {
  const std::string method = small(metadata.interpolation);
  if ((method != "hermite" && method != "lagrange") || !metadata.interpolation_degree) return std::nullopt;
  return Interpolation{method == "hermite" ? "HERMITE" : "LAGRANGE", *metadata.interpolation_degree};
}

void require_samples(const std::string& file, const Interpolation& interpolation,
                     const std::vector<detail::OrbitLine>& lines) {
  for (std::size_t begin = 0, end = 0; begin < lines.size(); begin = end) {
    end = begin + 1;
    while (end < lines.size() && (lines[end].time - lines[end - 1].time).value() <= longest_gap) ++end;
    if (end - begin < interpolation.samples())
      throw BadInput(file + ": " + counted(end - begin, "sample") + " from " + lines[begin].time.utc() +
                     " UTC" + (end - begin == lines.size() ? "" : ", without a step above an hour") + "; " +
                     interpolation.name() + " needs " + detail::text(interpolation.samples()));
  }
}

// The segment, with an interpolation that has its samples.
OrbitEphemerisSegment interpolated(const std::string& file, const OrbitEphemerisSegment& segment,
                                   const StatedInterpolation& stated) {
  EphemerisMetadata metadata = segment.metadata();
  const auto said = said_by(metadata);
  if (!said && !stated.value)
    throw BadInput(
        file + ": " +
        (metadata.interpolation.empty()
             ? "the file does not say how to interpolate"
             : "INTERPOLATION is '" + metadata.interpolation + "', of degree " +
                   (metadata.interpolation_degree ? detail::text(*metadata.interpolation_degree) : "none") +
                   ", none of hermite and lagrange with a degree") +
        "; missing: " + stated.word);
  const Interpolation interpolation = said ? *said : *stated.value;
  require_degree(file + ": ", interpolation);
  const detail::OrbitLines& lines = segment.lines(detail::trusted);
  require_samples(file, interpolation, lines.lines);
  metadata.interpolation = interpolation.method;
  metadata.interpolation_degree = interpolation.degree;
  return {detail::trusted, metadata, lines};
}

FlownOrbit orbit_of(const std::string& file, const OrbitEphemerisSegment& segment, const TimeSpan& span,
                    const std::optional<EarthOrientation>& orientation) {
  if (small(segment.metadata().center_name) != "earth")
    throw BadInput(file + ": CENTER_NAME is '" + segment.metadata().center_name +
                   "'; the orbit must be about EARTH");
  const std::string name = small(segment.ref_frame());
  const bool is_teme = name == "teme" || name == "temeofdate";
  const auto reference = inertial(name);
  const bool is_itrf = name.starts_with("itrf");
  if (is_itrf && !orientation)
    throw BadInput(file + ": REF_FRAME is '" + segment.ref_frame() +
                   "'; ITRF needs the orientation of the Earth: --orientation FILE, or orientation = "
                   "\"FILE\" in [earth] "
                   "of a scenario");
  if (!is_teme && !reference && !is_itrf)
    throw BadInput(file + ": REF_FRAME is '" + segment.ref_frame() +
                   "', none of EME2000, GCRF, TEME and ITRF");
  if (is_teme && segment.ref_frame_epoch())
    throw BadInput(file + ": REF_FRAME_EPOCH stops " + segment.ref_frame() + "; it is taken of date");
  const auto gap = longest_gap * si::second;
  if (is_itrf)
    return flown(edge(EarthMotion(*orientation, span)), segment.sampled_edge<Itrf, Satellite>(gap));
  if (is_teme) return flown_in_teme(span, segment.sampled_edge<Teme, Satellite>(gap));
  if (*reference == "EME2000")
    return flown(rigid_edge(coincident(eme2000_from_gcrf())), segment.sampled_edge<Eme2000, Satellite>(gap));
  return flown(segment.sampled_edge<Gcrf, Satellite>(gap));
}

// The one spacecraft of a kernel: SPICE gives spacecraft negative numbers.
std::int32_t spacecraft_of(const std::string& file, const EphemerisKernel& kernel) {
  std::set<std::int32_t> there;
  for (const EphemerisKernelSegment& segment : kernel.segments())
    if (segment.target < 0) there.insert(segment.target);
  std::string list;
  for (const std::int32_t id : there) list += (list.empty() ? "" : ", ") + detail::text(id);
  if (there.size() != 1)
    throw BadInput(file + ": an orbit is taken from a kernel of one spacecraft; this one has " +
                   (list.empty() ? "none" : list));
  return *there.begin();
}

}  // namespace

Epoch middle_of(const TimeSpan& span) {
  return span.start() + 0.5 * (span.end() - span.start());
}

FlownOrbit orbit_of_kernel(const std::filesystem::path& file, const TimeSpan& span) {
  const auto kernel = EphemerisKernel::open(file);
  const auto satellite = called<Satellite>(detail::text(spacecraft_of(file.string(), kernel)));
  return in_plain_words(file.string(), [&] {
    const auto orbit = kernel.motion(of<Satellite>, relative_to<Gcrf>, span, satellite);
    return FlownOrbit([orbit, name = file.string()](const Epoch& t) {
      return in_plain_words(name, [&] { return orbit.at(t); });
    });
  });
}

FlownOrbit orbit_of_elements(const std::vector<ElementSet>& all, const std::filesystem::path& file,
                             const TimeSpan& span, const std::optional<Epoch>& nearest_to,
                             const StatedSatellite& satellite) {
  const auto sets = of_satellite(all, file, satellite);
  const Epoch middle = nearest_to.value_or(middle_of(span));
  const auto nearest = std::min_element(sets.begin(), sets.end(), [&](const auto& a, const auto& b) {
    return std::abs((a.elements.epoch - middle).value()) < std::abs((b.elements.epoch - middle).value());
  });
  const Epoch& epoch = nearest->elements.epoch;
  const double age =
      std::max(std::abs((span.start() - epoch).value()), std::abs((span.end() - epoch).value()));
  constexpr double day = 86400.0;
  if (age > longest_age)
    throw BadInput(file.string() + ": the nearest element set, of " + epoch.utc(0) + " UTC, is " +
                   shown(std::ceil(age / day)) + " days from the times that are looked at; at most " +
                   shown(longest_age / day) + " are allowed");
  const auto orbit = in_plain_words(file.string(), [&] {
    return flown_in_teme(span, edge(Sgp4<Satellite>(nearest->elements, at_most(longest_age * si::second))));
  });
  return [orbit, name = file.string()](const Epoch& t) {
    return in_plain_words(name, [&] { return orbit(t); });
  };
}

FlownOrbit orbit_of_message(const std::filesystem::path& file, const TimeSpan& span,
                            const StatedInterpolation& stated,
                            const std::optional<EarthOrientation>& orientation) {
  const auto message = read_orbit_message(file);
  const auto& segments = message.segments();
  if (stated.value && std::all_of(segments.begin(), segments.end(), [](const auto& segment) {
        return said_by(segment.metadata()).has_value();
      }))
    throw BadInput(file.string() + ": says itself how to interpolate, " +
                   said_by(segments.front().metadata())->name() + "; " + stated.name() +
                   " is for a message that does not say it");
  struct Part {
    TimeSpan span;
    FlownOrbit orbit;
  };
  std::vector<Part> parts;
  for (const auto& segment : segments) {
    const auto& lines = segment.lines(detail::trusted).lines;
    const auto usable = interpolated(file.string(), segment, stated);
    parts.push_back({from_until(lines.front().time, lines.back().time), in_plain_words(file.string(), [&] {
                       return orbit_of(file.string(), usable, span, orientation);
                     })});
  }
  return [parts, name = file.string()](const Epoch& t) {
    for (const Part& part : parts) {
      // A kernel has its times to 1e-7 s: an attitude that begins with the orbit may be that much before it.
      constexpr double of_rounding = 1e-6;  // s
      const Epoch there = std::clamp(t, part.span.start(), part.span.end());
      if (std::abs((there - t).value()) <= of_rounding)
        return in_plain_words(name, [&] { return part.orbit(there); });
    }
    std::string spans;
    for (const Part& part : parts)
      spans += (spans.empty() ? "" : ", ") + part.span.start().utc(3) + " to " + part.span.end().utc(3);
    throw BadInput(name + ": the epoch " + t.utc() + " UTC of an attitude is in no segment; they are from " +
                   spans);
  };
}

FlownOrbit orbit_of_table(const OrbitFile& source, const TimeSpan& span, const Interpolation& interpolation,
                          const std::optional<EarthOrientation>& orientation) {
  const OrbitRecord record = read_orbit_file(source);
  EphemerisMetadata metadata;
  metadata.center_name = "EARTH";
  const std::string file = source.file.string();
  const auto usable = interpolated(file, {detail::trusted, metadata, record.lines}, {interpolation});
  const auto orbit = in_plain_words(file, [&] { return orbit_of(file, usable, span, orientation); });
  return [orbit, file](const Epoch& t) { return in_plain_words(file, [&] { return orbit(t); }); };
}

}  // namespace vectrix::cli

#include "flown_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace vectrix::cli {
namespace {

using earth::Eme2000, earth::Gcrf, earth::Teme;

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

FlownOrbit orbit_of(const OrbitEphemerisSegment& segment, const TimeSpan& span) {
  const auto longest_gap = convert<si::time>(1.0 * si::hour);
  const auto& name = segment.ref_frame();
  if (name == "TEME" || name == "TEMEOFDATE")
    return flown_in_teme(span, segment.sampled_edge<Teme, Satellite>(longest_gap));
  if (name == "EME2000" || name == "J2000")
    return flown(rigid_edge(coincident(eme2000_from_gcrf())),
                 segment.sampled_edge<Eme2000, Satellite>(longest_gap));
  return flown(segment.sampled_edge<Gcrf, Satellite>(longest_gap));
}

}  // namespace

FlownOrbit orbit_of_elements(const std::filesystem::path& file, const TimeSpan& span) {
  const auto sets = TwoLineElements::read(file);
  const Epoch middle = span.start() + 0.5 * (span.end() - span.start());
  const auto nearest = std::min_element(sets.begin(), sets.end(), [&](const auto& a, const auto& b) {
    return std::abs((a.epoch() - middle).value()) < std::abs((b.epoch() - middle).value());
  });
  return flown_in_teme(span, edge(Sgp4<Satellite>(*nearest, at_most(7.0 * si::day))));
}

FlownOrbit orbit_of_message(const std::filesystem::path& file, const TimeSpan& span) {
  const auto message = OrbitEphemerisMessage::read(file);
  struct Part {
    TimeSpan span;
    FlownOrbit orbit;
  };
  std::vector<Part> parts;
  for (const auto& segment : message.segments()) {
    const auto& lines = segment.lines(detail::trusted).lines;
    parts.push_back({from_until(lines.front().time, lines.back().time), orbit_of(segment, span)});
  }
  return [parts, name = file.string()](const Epoch& t) {
    for (const Part& part : parts) {
      if (part.span.contains(t)) return part.orbit(t);
    }
    throw BadInput(name + ": the epoch " + t.utc() + " UTC of an attitude is in no segment");
  };
}

}  // namespace vectrix::cli

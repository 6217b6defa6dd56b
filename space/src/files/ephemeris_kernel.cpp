#include <vectrix/space/files/ephemeris_kernel.hpp>

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include <vectrix/frames/errors.hpp>

#include "../time/date.hpp"
#include "frame_claim.hpp"
#include "kernel_names.hpp"
#include "orbit_source.hpp"
#include "text_file.hpp"

namespace vectrix {
namespace {

using detail::PlainMotion;

std::string shown_body(std::int32_t id) {
  const auto name = detail::name_of_body(id);
  return name ? "'" + *name + "' (" + detail::text(id) + ")" : detail::text(id);
}

/// R_eclipj2000^j2000: coordinates in the ecliptic of J2000 to those in its equator.
Eigen::Matrix3d equator_from_ecliptic() {
  constexpr double obliquity = 84381.448 / 3600.0 * std::numbers::pi / 180.0;
  return Eigen::AngleAxisd(obliquity, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

bool is_known_frame(std::int32_t frame) {
  return frame == detail::j2000_id || frame == detail::ecliptic_j2000_id;
}

/// The frame of the claim, with the axes of J2000 or of the ecliptic.
std::int32_t frame_of(const std::string& place, const detail::FrameClaim& a) {
  if (!a.name && a.standard == detail::StandardFrame::gcrf) return detail::j2000_id;
  const auto number = a.name ? detail::kernel_id(*a.name) : std::nullopt;
  const auto named = a.name ? detail::id_of_frame(*a.name) : std::nullopt;
  const std::int32_t frame = number ? *number : named ? *named : 0;
  if (!is_known_frame(frame))
    throw BadInput(place + ": asked for axes of " +
                   (a.name ? "'" + detail::excerpt(*a.name) + "' (" + a.type + ")" : a.type) +
                   "; it has those of J2000, which is earth::Gcrf, and ECLIPJ2000");
  detail::require_kernel_claim(place, frame, a);
  return frame;
}

std::int32_t body_of_name(const std::string& place, const std::string& name, const std::string& type) {
  const auto number = detail::kernel_id(name);
  const auto known = detail::id_of_body(name);
  if (!number && !known)
    throw BadInput(place + ": '" + detail::excerpt(name) + "' (" + type +
                   ") is no body that is known by name; give its number");
  return number ? *number : *known;
}

bool is_read(int type) {
  constexpr int types[] = {2, 3, 8, 9, 10, 12, 13};
  return std::find(std::begin(types), std::end(types), type) != std::end(types);
}

std::unique_ptr<const detail::OrbitSource> source_of(const detail::OrbitPart& part, int type) {
  if (type == 2 || type == 3) return detail::chebyshev_source(part, type);
  if (type == 10) return detail::element_sets_source(part);
  return detail::states_source(part, type);
}

}  // namespace

struct detail::LoadedSegment {
  double first, last;
  std::int32_t center;
  bool is_ecliptic;
  std::unique_ptr<const OrbitSource> source;
  std::string refusal;  // of one that cannot be read
};

/// What was loaded of each body, the last in the file first.
struct detail::OrbitSegments {
  std::string place;
  TimeSpan span;  // that was asked for
  std::int32_t target, center;
  bool in_ecliptic;
  std::map<std::int32_t, std::vector<LoadedSegment>> bodies;

  [[nodiscard]] const LoadedSegment* find(std::int32_t body, const SecondsSince2000& t) const {
    const auto found = bodies.find(body);
    if (found == bodies.end()) return nullptr;
    constexpr double rounding = 1e-6;  // s, some ulp of a time
    for (const LoadedSegment& segment : found->second) {
      if (t.since(segment.first) >= -rounding && t.since(segment.last) <= rounding) return &segment;
    }
    return nullptr;
  }
  /// The body, and those to which its segments lead at any time.
  [[nodiscard]] std::set<std::int32_t> reached_from(std::int32_t body) const {
    std::set<std::int32_t> reached;
    std::vector<std::int32_t> waiting{body};
    while (!waiting.empty()) {
      const std::int32_t next = waiting.back();
      waiting.pop_back();
      const auto found = bodies.find(next);
      if (!reached.insert(next).second || found == bodies.end()) continue;
      for (const LoadedSegment& segment : found->second) waiting.push_back(segment.center);
    }
    return reached;
  }
  /// The segments from a body to the one that has none, and the bodies on the way.
  struct Way {
    std::vector<std::int32_t> bodies;
    std::vector<const LoadedSegment*> segments;
  };
  [[nodiscard]] Way way_from(std::int32_t body, const SecondsSince2000& t) const {
    Way way{{body}, {}};
    while (const LoadedSegment* const segment = find(way.bodies.back(), t)) {
      if (way.bodies.size() > bodies.size())
        throw BadInput(place + ": the segments lead from " + shown_body(body) + " in a circle");
      way.segments.push_back(segment);
      way.bodies.push_back(segment->center);
    }
    return way;
  }
};

PlainMotion detail::KernelOrbit::at(const Epoch& epoch) const {
  const OrbitSegments& all = *segments_;
  const SecondsSince2000 t = ephemeris_time(epoch);
  const auto up = all.way_from(all.target, t), down = all.way_from(all.center, t);
  const auto meeting =
      std::find_first_of(up.bodies.begin(), up.bodies.end(), down.bodies.begin(), down.bodies.end());
  if (meeting == up.bodies.end() && (epoch < all.span.start() || all.span.end() < epoch))
    throw BadInput(all.place + ": the epoch " + shown(epoch) + " is outside the times that were read, " +
                   shown(all.span.start()) + " to " + shown(all.span.end()));
  if (meeting == up.bodies.end()) {
    const auto last = [&](const OrbitSegments::Way& way) {
      const std::int32_t body = way.bodies.back();
      return shown_body(body) + (all.bodies.contains(body) ? ", of which they have nothing then" : "");
    };
    throw BadInput(all.place + ": at " + shown(epoch) + " its segments lead from " + shown_body(all.target) +
                   " to " + last(up) + ", and from " + shown_body(all.center) + " to " + last(down));
  }
  static const Eigen::Matrix3d R_equator_from_ecliptic = equator_from_ecliptic();
  PlainMotion sum{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const auto add = [&](const LoadedSegment& segment, double sign) {
    if (!segment.source) throw BadInput(segment.refusal);
    PlainMotion motion = segment.source->at(t);
    if (segment.is_ecliptic)
      motion = {R_equator_from_ecliptic * motion.position, R_equator_from_ecliptic * motion.velocity};
    sum = {sum.position + sign * motion.position, sum.velocity + sign * motion.velocity};
  };
  for (std::size_t i = 0; up.bodies[i] != *meeting; ++i) add(*up.segments[i], 1.0);
  for (std::size_t i = 0; down.bodies[i] != *meeting; ++i) add(*down.segments[i], -1.0);
  if (!sum.position.allFinite() || !sum.velocity.allFinite())
    throw BadInput(all.place + ": at " + shown(epoch) + " its numbers are too large");
  if (all.in_ecliptic)
    sum = {R_equator_from_ecliptic.transpose() * sum.position,
           R_equator_from_ecliptic.transpose() * sum.velocity};
  return sum;
}

std::string EphemerisKernel::place() const {
  return "ephemeris kernel" + file_.place().substr(std::string_view("DAF file").size());
}
std::string EphemerisKernel::place_of(std::size_t segment) const {
  return place() + ", segment " + detail::text(segment + 1) + " '" + segments_[segment].name + "'";
}

EphemerisKernel EphemerisKernel::open(const std::filesystem::path& file) {
  EphemerisKernel kernel(DafFile::open(file));
  const DafFile& daf = kernel.file_;
  if (!daf.kind().empty() && daf.kind() != "SPK")
    throw BadInput(daf.place() + ": it is a file of the kind '" + daf.kind() + "', not SPK");
  for (const DafFile::Array& array : daf.arrays()) {
    const Epoch unknown = Epoch::from_tt("2000-01-01T12:00:00");
    kernel.segments_.push_back({array.name, 0, 0, 0, 0, unknown, unknown});
    EphemerisKernelSegment& segment = kernel.segments_.back();
    const std::string place = kernel.place_of(kernel.segments_.size() - 1);
    if (array.doubles.size() != 2 || array.integers.size() != 4)
      throw BadInput(place + ": a summary of " + detail::text(array.doubles.size()) + " doubles and " +
                     detail::text(array.integers.size() + 2) + " integers; an ephemeris kernel has 2 and 6");
    segment.target = array.integers[0];
    segment.center = array.integers[1];
    segment.frame = array.integers[2];
    segment.type = array.integers[3];
    if (segment.target == segment.center)
      throw BadInput(place + ": it is of " + shown_body(segment.target) + " relative to itself");
    if (!(array.doubles[0] <= array.doubles[1]))
      throw BadInput(place + ": it goes from " + detail::text(array.doubles[0]) + " to " +
                     detail::text(array.doubles[1]) + " s");
    segment.start = detail::epoch_of_ephemeris_time({array.doubles[0], 0.0}, place);
    segment.end = detail::epoch_of_ephemeris_time({array.doubles[1], 0.0}, place);
  }
  if (kernel.segments_.empty()) throw BadInput(daf.place() + ": it has no segments");
  return kernel;
}

TimeSpan EphemerisKernel::span() const {
  Epoch start = segments_.front().start, end = segments_.front().end;
  for (const EphemerisKernelSegment& segment : segments_) {
    start = std::min(start, segment.start);
    end = std::max(end, segment.end);
  }
  return from_until(start, end);
}

std::string EphemerisKernel::refusal_of(std::size_t segment, const detail::FrameClaim& a) const {
  const EphemerisKernelSegment& asked = segments_[segment];
  if (!is_read(asked.type))
    return place_of(segment) + ": it is of type " + detail::text(asked.type) +
           "; the types 2, 3, 8, 9, 10, 12 and 13 are read";
  if (!is_known_frame(asked.frame))
    return place_of(segment) + ": its frame is " + detail::text(asked.frame) +
           "; J2000 (1) and ECLIPJ2000 (17) are read; asked for " + a.type;
  return {};
}

detail::KernelOrbit EphemerisKernel::orbit(const detail::FrameClaim& q, const detail::FrameClaim& a,
                                           const TimeSpan& span) const {
  const std::string place = this->place();
  if (q.center != detail::default_center)
    throw BadInput(place + ": the claim of the body " + detail::shown(q) + " has the centre '" +
                   detail::excerpt(q.center) + "', which belongs to that of " + a.type);
  const auto all = std::make_shared<detail::OrbitSegments>(
      detail::OrbitSegments{place,
                            span,
                            body_of_name(place, q.name ? *q.name : detail::name_of(q), q.type),
                            body_of_name(place, a.center, a.type),
                            frame_of(place, a) == detail::ecliptic_j2000_id,
                            {}});

  std::map<std::int32_t, std::vector<std::size_t>> by_body;
  std::set<std::string> pairs;
  constexpr std::size_t most_pairs = 8;
  for (std::size_t i = segments_.size(); i-- > 0;) {
    by_body[segments_[i].target].push_back(i);
    if (pairs.size() < most_pairs)
      pairs.insert(shown_body(segments_[i].target) + " relative to " + shown_body(segments_[i].center));
  }
  const double first = detail::ephemeris_time(span.start()).since(0.0),
               last = detail::ephemeris_time(span.end()).since(0.0);
  std::vector<std::int32_t> waiting{all->target, all->center};
  std::set<std::int32_t> seen;
  while (!waiting.empty()) {
    const std::int32_t body = waiting.back();
    waiting.pop_back();
    if (!seen.insert(body).second) continue;
    for (const std::size_t i : by_body[body]) {
      const DafFile::Array& array = file_.arrays()[i];
      if (array.doubles[1] < first || last < array.doubles[0]) continue;
      const std::string refusal = refusal_of(i, a);
      const double from = std::max(first, array.doubles[0]), until = std::min(last, array.doubles[1]);
      const detail::OrbitPart part{place_of(i), file_, array, from, until};
      all->bodies[body].push_back({from, until, segments_[i].center,
                                   segments_[i].frame == detail::ecliptic_j2000_id,
                                   refusal.empty() ? source_of(part, segments_[i].type) : nullptr, refusal});
      waiting.push_back(segments_[i].center);
    }
  }
  const std::set<std::int32_t> from_target = all->reached_from(all->target);
  const std::set<std::int32_t> from_center = all->reached_from(all->center);
  const bool meet = std::any_of(from_center.begin(), from_center.end(),
                                [&](std::int32_t body) { return from_target.contains(body); });
  if (!meet || all->target == all->center) {
    std::string list;
    for (const std::string& pair : pairs) list += (list.empty() ? "" : "; ") + pair;
    throw BadInput(all->place + ": it has " + list + ", from " + detail::shown(this->span().start()) +
                   " to " + detail::shown(this->span().end()) + "; asked for " + shown_body(all->target) +
                   " (" + q.type + ") relative to " + shown_body(all->center) + " (" + a.type + ") from " +
                   detail::shown(span.start()) + " to " + detail::shown(span.end()));
  }
  // From a body that both lead to their ways are one, and what is there is not needed.
  for (const auto& [body, segments] : all->bodies) {
    if (from_target.contains(body) == from_center.contains(body)) continue;
    for (const detail::LoadedSegment& segment : segments) {
      if (!segment.refusal.empty()) throw BadInput(segment.refusal);
    }
  }
  return detail::KernelOrbit(all);
}

}  // namespace vectrix

#include <vectrix/space/files/attitude_kernel.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "../time/date.hpp"
#include "attitude_priority.hpp"
#include "attitude_records.hpp"
#include "frame_claim.hpp"
#include "kernel_names.hpp"

namespace vectrix {
namespace detail {

KernelTurns::KernelTurns(std::string place, const SpacecraftClock& clock,
                         std::vector<AttitudeRecords> segments)
    : place_(std::move(place)),
      clock_(clock),
      segments_(std::make_shared<const std::vector<AttitudeRecords>>(std::move(segments))) {}

void KernelTurns::fail(const Epoch& epoch, double ticks) const {
  for (const AttitudeRecords& records : *segments_) {
    if (records.is_alone(ticks))
      throw BadInput(records.place() + ": the record of " + shown(epoch) + ", " + text(ticks) +
                     " ticks, is alone in its interval, and nothing says how it turns; samples() has it");
  }
  throw BadInput(place_ + ": the epoch " + shown(epoch) + ", " + text(ticks) +
                 " ticks, is outside the intervals that were read");
}

KernelTurn KernelTurns::at(const Epoch& epoch) const {
  const double ticks = clock_.ticks(epoch).count;
  for (const AttitudeRecords& records : *segments_) {
    const auto where = records.find(ticks);
    if (!where) continue;
    const double step = records.ticks_of_step(*where) * clock_.seconds_per_tick(trusted, ticks);
    const KernelTurn now = records.at(*where, step);
    if (!now.q_a_from_b.coeffs().allFinite() || !now.w_ab_b.allFinite())
      throw BadInput(records.place() + ": at " + shown(epoch) + " its numbers are too large");
    return now;
  }
  fail(epoch, ticks);
}

Eigen::Vector3d KernelTurns::recorded_rate(const Epoch& epoch) const {
  const double ticks = clock_.ticks(epoch).count;
  for (const AttitudeRecords& records : *segments_) {
    if (const auto where = records.find(ticks)) return records.recorded_rate(*where);
  }
  fail(epoch, ticks);
}

}  // namespace detail

namespace {

bool is_read_attitude(int type) {
  return type >= 1 && type <= 3;
}

}  // namespace

AttitudeKernel::AttitudeKernel(DafFile file, const SpacecraftClock& clock, const FrameKernel& frames)
    : file_(std::move(file)), clock_(clock), frames_(frames) {}

AttitudeKernel AttitudeKernel::open(const std::filesystem::path& file, const SpacecraftClock& clock,
                                    const FrameKernel& frames) {
  AttitudeKernel kernel(DafFile::open(file), clock, frames);
  const DafFile& daf = kernel.file_;
  if (!daf.kind().empty() && daf.kind() != "CK")
    throw BadInput(daf.place() + ": it is a file of the kind '" + daf.kind() + "', not CK");
  for (const DafFile::Array& array : daf.arrays()) {
    kernel.segments_.push_back({array.name, 0, 0, 0, false, Epoch::from_tt("2000-01-01T12:00:00"),
                                Epoch::from_tt("2000-01-01T12:00:00")});
    AttitudeKernelSegment& segment = kernel.segments_.back();
    const std::string place = kernel.place_of(kernel.segments_.size() - 1);
    if (array.doubles.size() != 2 || array.integers.size() != 4)
      throw BadInput(place + ": a summary of " + detail::text(array.doubles.size()) + " doubles and " +
                     detail::text(array.integers.size() + 2) + " integers; an attitude kernel has 2 and 6");
    segment.frame = array.integers[0];
    segment.reference = array.integers[1];
    segment.type = array.integers[2];
    const std::int32_t flag = array.integers[3];
    if (flag != 0 && flag != 1) throw BadInput(place + ": the flag of the rates is " + detail::text(flag));
    segment.has_rates = flag == 1 || segment.type == 2;
    kernel.frames_.require_clock(place, segment.frame, clock.id());
    if (!(array.doubles[0] <= array.doubles[1]))
      throw BadInput(place + ": it goes from " + detail::text(array.doubles[0]) + " to " +
                     detail::text(array.doubles[1]) + " ticks");
    try {
      segment.start = clock.epoch({array.doubles[0]});
      segment.end = clock.epoch({array.doubles[1]});
    } catch (const BadInput& error) {
      throw BadInput(place + ": " + error.what());
    }
    if (is_read_attitude(segment.type)) static_cast<void>(detail::attitude_layout(daf, array, place));
  }
  if (kernel.segments_.empty()) throw BadInput(daf.place() + ": it has no segments");
  return kernel;
}

std::string AttitudeKernel::place_of(std::size_t segment) const {
  return "attitude kernel" + file_.place().substr(std::string_view("DAF file").size()) + ", segment " +
         detail::text(segment + 1) + " '" + segments_[segment].name + "'";
}

TimeSpan AttitudeKernel::span() const {
  Epoch start = segments_.front().start, end = segments_.front().end;
  for (const AttitudeKernelSegment& segment : segments_) {
    start = std::min(start, segment.start);
    end = std::max(end, segment.end);
  }
  return from_until(start, end);
}

std::vector<std::size_t> AttitudeKernel::segments_of(const detail::FrameClaim& b, const detail::FrameClaim& a,
                                                     const TimeSpan& span) const {
  const std::int32_t frame = frames_.attitude_id_of(b), reference = frames_.id_of(a);
  std::vector<std::size_t> found;
  std::set<std::string> others;
  constexpr std::size_t most_others = 5;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (segments_[i].frame == frame && segments_[i].reference == reference) {
      found.push_back(i);
    } else if (others.size() < most_others) {
      others.insert(frames_.shown(segments_[i].frame) + " relative to " +
                    frames_.shown(segments_[i].reference));
    }
  }
  if (found.empty()) {
    std::string list;
    for (const std::string& other : others) list += (list.empty() ? "" : "; ") + other;
    throw BadInput("attitude kernel" + file_.place().substr(std::string_view("DAF file").size()) +
                   ": it has " + list + "; asked for " + frames_.shown(frame) + " (" + b.type +
                   ") relative to " + frames_.shown(reference) + " (" + a.type + ")");
  }
  const std::size_t first = found.front();
  std::erase_if(found, [&](std::size_t i) {
    return segments_[i].end < span.start() || span.end() < segments_[i].start;
  });
  if (found.empty())
    throw BadInput(place_of(first) + ": it goes from " + detail::shown(segments_[first].start) + " to " +
                   detail::shown(segments_[first].end) + "; asked for " + detail::shown(span.start()) +
                   " to " + detail::shown(span.end()));
  return found;
}

std::vector<detail::AttitudeRecords> AttitudeKernel::load(const std::vector<std::size_t>& segments,
                                                          const TimeSpan& span) const {
  std::vector<detail::AttitudeRecords> all;
  for (const std::size_t i : segments) {
    // Of instants outside the clock's time the segment has nothing.
    const AttitudeKernelSegment& segment = segments_[i];
    const DafFile::Array& array = file_.arrays()[i];
    if (!is_read_attitude(segment.type))
      throw BadInput(place_of(i) + ": it is of type " + detail::text(segment.type) +
                     "; the types 1, 2 and 3 are read");
    const double first = span.start() <= segment.start ? array.doubles[0] : clock_.ticks(span.start()).count;
    const double last = segment.end <= span.end() ? array.doubles[1] : clock_.ticks(span.end()).count;
    all.emplace_back(place_of(i), file_, array, first, last, clock_.rounding(detail::trusted, last));
  }
  return all;
}

detail::KernelTurns AttitudeKernel::turns(const detail::FrameClaim& b, const detail::FrameClaim& a,
                                          const TimeSpan& span) const {
  auto all = load(segments_of(b, a, span), span);
  for (const detail::AttitudeRecords& records : all) {
    if (records.type() == 1)
      throw BadInput(records.place() +
                     ": type 1 has single attitudes and nothing between them; take samples(), "
                     "or nearest_sample()");
  }
  std::reverse(all.begin(), all.end());  // the last one counts
  return {"attitude kernel" + file_.place().substr(std::string_view("DAF file").size()) + ", " + b.type +
              " relative to " + a.type,
          clock_, std::move(all)};
}

std::vector<detail::KernelAttitudeRecord> AttitudeKernel::records(const detail::FrameClaim& b,
                                                                  const detail::FrameClaim& a,
                                                                  const TimeSpan& span) const {
  const auto all = load(segments_of(b, a, span), span);
  std::vector<detail::KernelAttitudeRecord> records;
  for (const detail::CountingRecord& one : detail::by_priority(all).records) {
    const detail::AttitudeRecords& segment = *one.segment;
    records.push_back({clock_.epoch({one.ticks}), one.q_a_from_b(),
                       segment.has_rates() ? std::optional{segment.w_ab_a(one.record)} : std::nullopt,
                       one.begins});
  }
  return records;
}

std::vector<TimeSpan> AttitudeKernel::coverage_of(const detail::FrameClaim& b, const detail::FrameClaim& a,
                                                  const TimeSpan& span) const {
  std::vector<detail::TickSpan> all;
  for (const detail::AttitudeRecords& segment : load(segments_of(b, a, span), span)) {
    if (segment.type() == 1) continue;
    for (const detail::TickSpan& interval : segment.intervals())
      if (interval.to - interval.from > segment.rounding()) all.push_back(interval);
  }
  std::sort(all.begin(), all.end(),
            [](const detail::TickSpan& x, const detail::TickSpan& y) { return x.from < y.from; });
  std::vector<TimeSpan> spans;
  for (const detail::TickSpan& one : detail::joined(all))
    spans.push_back(from_until(clock_.epoch({one.from}), clock_.epoch({one.to})));
  return spans;
}

std::vector<HiddenAttitude> AttitudeKernel::hidden_of(const detail::FrameClaim& b,
                                                      const detail::FrameClaim& a,
                                                      const TimeSpan& span) const {
  const auto segments = segments_of(b, a, span);
  const auto all = load(segments, span);
  std::vector<HiddenAttitude> hidden;
  for (const detail::HiddenTicks& one : detail::by_priority(all).hidden)
    hidden.push_back(
        {segments[one.segment], from_until(clock_.epoch({one.ticks.from}), clock_.epoch({one.ticks.to}))});
  return hidden;
}

detail::KernelAttitudeRecord AttitudeKernel::nearest(const detail::FrameClaim& b, const detail::FrameClaim& a,
                                                     const Epoch& t,
                                                     const Quantity<si::time>& tolerance) const {
  if (!(tolerance.value() >= 0.0 && std::isfinite(tolerance.value())))
    throw BadInput(file_.place() + ": the tolerance is " + detail::text(tolerance.value()) + " s");
  const auto all = records(b, a, from_until(t - tolerance, t + tolerance));
  const auto distance = [&](const detail::KernelAttitudeRecord& record) {
    return std::abs((record.time - t).value());
  };
  const auto nearest = std::min_element(
      all.begin(), all.end(), [&](const auto& x, const auto& y) { return distance(x) < distance(y); });
  if (nearest == all.end())
    throw BadInput(file_.place() + ": no record of " + b.type + " relative to " + a.type + " is within " +
                   detail::text(tolerance.value()) + " s of " + detail::shown(t));
  return *nearest;
}

const Eigen::Vector3d& AttitudeKernel::rate_of(const detail::KernelAttitudeRecord& record) const {
  if (!record.w_ab_a)
    throw BadInput(file_.place() + ": the record of " + detail::shown(record.time) + " has no rate");
  return *record.w_ab_a;
}

}  // namespace vectrix

#include "attitude_priority.hpp"

#include <algorithm>
#include <limits>

namespace vectrix::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Stretches in the order of time that do not touch.
class Covered {
 public:
  void add(const std::vector<TickSpan>& more) {
    const auto middle = all_.insert(all_.end(), more.begin(), more.end());
    std::inplace_merge(all_.begin(), middle, all_.end(),
                       [](const TickSpan& a, const TickSpan& b) { return a.from < b.from; });
    all_ = joined(all_);
  }
  [[nodiscard]] bool has(double ticks, double rounding) const {
    const auto next = ending_from(ticks - rounding);
    return next != all_.end() && next->from <= ticks + rounding;
  }
  // Of an instant that is in none: where the one before it ends and the next one starts.
  [[nodiscard]] TickSpan around(double ticks) const {
    const auto next = ending_from(ticks);
    return {next == all_.begin() ? -infinity : (next - 1)->to, next == all_.end() ? infinity : next->from};
  }
  [[nodiscard]] std::vector<TickSpan> within(const TickSpan& span, double rounding) const {
    std::vector<TickSpan> parts;
    for (auto next = ending_from(span.from); next != all_.end() && next->from < span.to; ++next) {
      const TickSpan part{std::max(span.from, next->from), std::min(span.to, next->to)};
      if (part.to - part.from > rounding) parts.push_back(part);
    }
    return parts;
  }

 private:
  [[nodiscard]] std::vector<TickSpan>::const_iterator ending_from(double ticks) const {
    return std::lower_bound(all_.begin(), all_.end(), ticks,
                            [](const TickSpan& span, double limit) { return span.to < limit; });
  }
  std::vector<TickSpan> all_;
};

// A record that counts, and the stretch around it that no later segment knows.
struct Placed {
  CountingRecord record;
  std::size_t segment;
  TickSpan free;
};

std::vector<CountingRecord> records_of(const AttitudeRecords& segment) {
  std::vector<CountingRecord> all;
  const auto add = [&](std::size_t i, double ticks) {
    if (ticks >= segment.first() - segment.rounding() && ticks <= segment.last() + segment.rounding())
      all.push_back({&segment, i, ticks, segment.begins(i) && ticks == segment.ticks(i)});
  };
  for (std::size_t i = 0; i < segment.size(); ++i) {
    if (segment.type() == 2) {
      for (const double ticks : segment.ticks_of_interval(i)) add(i, ticks);
    } else {
      add(i, segment.ticks(i));
    }
  }
  return all;
}

// Whether the motion of `lower` goes on from one of two neighbours to the other, and is there as `upper`
// says.
bool leads_on(const Placed& lower, const Placed& upper) {
  const AttitudeRecords& segment = *lower.record.segment;
  const double ticks = upper.record.ticks;
  if (segment.type() == 1 || ticks < lower.free.from - segment.rounding() ||
      ticks > lower.free.to + segment.rounding())
    return false;
  const auto where = segment.find(ticks);
  if (!where) return false;
  const auto [first, second] = std::minmax(lower.record.record, where->record);
  if (first != second && (first + 1 != second || segment.begins(second))) return false;
  constexpr double same = 1e-12;  // rad, some roundings of a quaternion
  return segment.at(*where, 1.0).q_a_from_b.angularDistance(upper.record.q_a_from_b()) < same;
}

bool begins_behind(const Placed& before, const Placed& next) {
  if (before.segment == next.segment) return next.record.begins || before.free.to < next.record.ticks;
  const auto& [lower, upper] =
      std::minmax(before, next, [](const Placed& a, const Placed& b) { return a.segment < b.segment; });
  const AttitudeRecords& segment = *lower.record.segment;
  if (segment.type() == 1 &&
      upper.record.segment->type() == 1)  // without intervals: unless one hides the other
    return segment.ticks(0) < upper.record.ticks && upper.record.ticks < segment.ticks(segment.size() - 1);
  return !leads_on(lower, upper);
}

}  // namespace

std::vector<TickSpan> joined(const std::vector<TickSpan>& sorted) {
  std::vector<TickSpan> all;
  for (const TickSpan& next : sorted) {
    if (!all.empty() && next.from <= all.back().to) {
      all.back().to = std::max(all.back().to, next.to);
    } else {
      all.push_back(next);
    }
  }
  return all;
}

Eigen::Quaterniond CountingRecord::q_a_from_b() const {
  if (segment->type() != 2) return segment->q_a_from_b(record);
  return segment->at({record, ticks - segment->ticks(record)}, 0.0).q_a_from_b;
}

AttitudePriority by_priority(const std::vector<AttitudeRecords>& segments) {
  Covered later;
  std::vector<Placed> placed;
  AttitudePriority result;
  for (std::size_t s = segments.size(); s-- > 0;) {
    const AttitudeRecords& segment = segments[s];
    for (const CountingRecord& record : records_of(segment))
      if (!later.has(record.ticks, segment.rounding()))
        placed.push_back({record, s, later.around(record.ticks)});
    const auto known = segment.intervals();
    for (const TickSpan& span : known)
      for (const TickSpan& part : later.within(span, segment.rounding())) result.hidden.push_back({s, part});
    later.add(known);
  }
  std::stable_sort(placed.begin(), placed.end(),
                   [](const Placed& a, const Placed& b) { return a.record.ticks < b.record.ticks; });
  std::stable_sort(result.hidden.begin(), result.hidden.end(),
                   [](const HiddenTicks& a, const HiddenTicks& b) { return a.segment < b.segment; });
  for (std::size_t i = 0; i < placed.size(); ++i) {
    CountingRecord record = placed[i].record;
    if (i > 0) record.begins = begins_behind(placed[i - 1], placed[i]);
    result.records.push_back(record);
  }
  return result;
}

}  // namespace vectrix::detail

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "attitude_records.hpp"

namespace vectrix::detail {

/// Stretches in the order of their begins, as those that do not touch.
std::vector<TickSpan> joined(const std::vector<TickSpan>& sorted);

/// A record, or of type 2 a point of an interval, at an instant that no later segment knows.
struct CountingRecord {
  const AttitudeRecords* segment;
  std::size_t record;
  double ticks;
  bool begins;  // from the one before nothing leads to it

  [[nodiscard]] Eigen::Quaterniond q_a_from_b() const;
};

/// A stretch of a segment, by its place among those that are given, at which a later one counts.
struct HiddenTicks {
  std::size_t segment;
  TickSpan ticks;
};

struct AttitudePriority {
  std::vector<CountingRecord> records;  // in the order of time
  std::vector<HiddenTicks> hidden;
};
/// Of segments in the order of a file, of which the last one that knows an instant counts. One of type 1
/// counts from its first record to its last. A step from one segment to another leads on where the earlier of
/// the two knows all of it, and has the attitude of the later one where they meet.
AttitudePriority by_priority(const std::vector<AttitudeRecords>& segments);

}  // namespace vectrix::detail

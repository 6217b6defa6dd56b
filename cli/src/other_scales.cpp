#include "other_scales.hpp"

#include "scales.hpp"

namespace vectrix::cli {
namespace {

bool is_like(const TimeScale& a, const TimeScale& b) {
  const auto is_dynamical = [](const TimeScale& scale) {
    return scale.kind() == TimeScale::Kind::tt || scale.kind() == TimeScale::Kind::tdb;
  };
  return a.kind() == b.kind() || (is_dynamical(a) && is_dynamical(b));
}

AttitudeRecord read_in(const TimeScale& scale, const AttitudeRecord& as_read) {
  AttitudeRecord record;
  record.file = as_read.file;
  record.body = as_read.body;
  record.reference = as_read.reference;
  record.stated = as_read.stated;
  record.has_quaternions = as_read.has_quaternions;
  record.message = as_read.message;
  constexpr std::size_t enough = 1000;
  const std::size_t each = (as_read.size() + enough - 1) / enough;
  for (std::size_t i = 0; i < as_read.size(); i += each) {
    const auto time = Epoch::from(scale, exact_text(as_read.times[i], as_read.time_scale));
    if (time < as_read.times.front() || as_read.times.back() < time) continue;
    record.times.push_back(time);
    record.numbers.push_back(as_read.numbers[i]);
  }
  return record;
}

}  // namespace

std::vector<ScaleReading> in_other_scales(const AttitudeRecord& as_read,
                                          const std::function<double(AttitudeRecord)>& measured) {
  std::vector<ScaleReading> found;
  if (as_read.times.front() < Epoch::from_utc("1981-01-01T00:00:00")) return found;  // GPS begins in 1980
  for (const auto& [name, scale] : scales()) {
    if (scale.kind() == TimeScale::Kind::tdb || is_like(scale, as_read.time_scale)) continue;
    AttitudeRecord record = read_in(scale, as_read);
    if (record.size() > 1) found.push_back({scale.name(), measured(std::move(record))});
  }
  return found;
}

}  // namespace vectrix::cli

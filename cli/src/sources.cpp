#include "sources.hpp"

#include <algorithm>
#include <cstddef>

namespace vectrix::cli {
namespace {

template <class Value> void keep(std::vector<Value>& values, std::ptrdiff_t first, std::ptrdiff_t last) {
  if (values.empty()) return;
  values.erase(values.begin() + last, values.end());
  values.erase(values.begin(), values.begin() + first);
}
void keep(AttitudeRecord& record, std::ptrdiff_t first, std::ptrdiff_t last) {
  keep(record.times, first, last);
  keep(record.numbers, first, last);
  keep(record.rates, first, last);
}

}  // namespace

AttitudeRecord read_attitude(const AttitudeSource& source) {
  AttitudeRecord record = source.columns ? read_table(source.file, *source.columns)
                                         : read_message(source.file, source.segment);
  const auto first = source.from ? std::lower_bound(record.times.begin(), record.times.end(), *source.from)
                                 : record.times.begin();
  const auto last = source.until ? std::upper_bound(record.times.begin(), record.times.end(), *source.until)
                                 : record.times.end();
  if (last - first < 2)
    throw BadInput(record.file + ": the samples from " + source.from.value_or(record.times.front()).utc() +
                   " UTC until " + source.until.value_or(record.times.back()).utc() + " UTC are " +
                   detail::text(std::max<std::ptrdiff_t>(last - first, 0)) + "; at least two are needed");
  keep(record, first - record.times.begin(), last - record.times.begin());
  return record;
}

FlownOrbit read_orbit(const OrbitSource& source, const TimeSpan& span) {
  if (!source.elements.empty() && !source.message.empty())
    throw BadInput("two orbits are given, --tle " + source.elements.string() + " and --oem " +
                   source.message.string());
  if (!source.elements.empty()) return orbit_of_elements(source.elements, span);
  if (!source.message.empty()) return orbit_of_message(source.message, span);
  return nullptr;
}

}  // namespace vectrix::cli

#include "sources.hpp"

namespace vectrix::cli {

AttitudeRecord read_attitude(const AttitudeSource& source) {
  AttitudeRecord record =
      source.columns ? read_table(source.file, *source.columns) : read_message(source.file, source.selection);
  const Places places = selected(record.times, source.selection, record.file);
  keep(record.times, places);
  keep(record.numbers, places);
  keep(record.rates, places);
  return record;
}

FlownOrbit read_orbit(const OrbitSource& source, const TimeSpan& span) {
  if (!source.elements.empty() && !source.message.empty())
    throw BadInput("two orbits are given, --tle " + source.elements.string() + " and --oem " +
                   source.message.string());
  if (!source.elements.empty()) return orbit_of_elements(source.elements, span);
  if (!source.message.empty())
    return orbit_of_message(source.message, span, source.interpolation, source.orientation);
  if (source.table)
    return orbit_of_table(*source.table, span, *source.interpolation.value, source.orientation);
  return nullptr;
}

}  // namespace vectrix::cli

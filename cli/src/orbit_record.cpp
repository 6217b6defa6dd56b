#include "orbit_record.hpp"

#include <algorithm>

#include "earth_frame.hpp"
#include "flown_orbit.hpp"
#include "message_kind.hpp"
#include "table_column.hpp"
#include "table_text.hpp"

namespace vectrix::cli {
namespace {

OrbitRecord of_message(const OrbitFile& source) {
  const auto message = read_orbit_message(source.file);
  const auto& segment = segment_of(message, source.selection, source.file);
  return {source.file.string(), segment.metadata().time_system,
          MessageText{message.header(), segment.metadata(), segment.comments()},
          segment.lines(detail::trusted)};
}

OrbitRecord of_table(const OrbitFile& source) {
  const OrbitColumns& columns = *source.columns;
  const auto table = CsvTable::read(source.file, {});
  require_column(table, source.file, columns.time);
  for (const auto* const group : {&columns.position, &columns.velocity})
    for (const std::string& name : *group) require_column(table, source.file, name);
  OrbitRecord record{source.file.string(), columns.scale, {}, {}};
  record.lines.ref_frame = stated_earth_frame("the reference", columns.reference);
  std::vector<detail::OrbitLine>& lines = record.lines.lines;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto time = table.value(row, columns.time,
                                  [&](const std::string& text) { return Epoch::from(columns.scale, text); });
    if (!lines.empty() && !(lines.back().time < time))
      table.refuse(row, columns.time, table.text(row, columns.time) + " is not after the row before");
    const auto vector = [&](const std::vector<std::string>& names) {
      Eigen::Vector3d v;
      for (std::size_t i = 0; i < 3; ++i)
        v[static_cast<Eigen::Index>(i)] = table.number(row, names[i], columns.in_kilometres ? 3 : 0);
      return v;
    };
    lines.push_back({time, vector(columns.position), vector(columns.velocity), std::nullopt});
  }
  return record;
}

PointMotion<OldAxes, Satellite, OldAxes> in_old_axes(const detail::OrbitLine& line) {
  return {Displacement<OldAxes, Satellite, In<OldAxes>>{detail::trusted, line.position},
          Velocity<OldAxes, Satellite, ObservedFrom<OldAxes>, In<OldAxes>>{detail::trusted, line.velocity}};
}

// Of axes that turn.
void require_turning(const OrbitRecord& record, const std::string& before) {
  if (record.message && small(record.message->metadata.center_name) != "earth")
    throw BadInput(record.file + ": CENTER_NAME is '" + record.message->metadata.center_name +
                   "'; only an orbit about EARTH is turned to or from axes of the Earth");
  if (record.lines.ref_frame_epoch && !inertial(before))
    throw BadInput(record.file + ": REF_FRAME_EPOCH stops " + record.lines.ref_frame +
                   "; it is turned as a frame of date only");
}

}  // namespace

OrbitRecord read_orbit_file(const OrbitFile& source) {
  OrbitRecord record = source.columns ? of_table(source) : of_message(source);
  auto& lines = record.lines.lines;
  std::vector<Epoch> times;
  for (const detail::OrbitLine& line : lines) times.push_back(line.time);
  if (times.empty()) throw BadInput(record.file + ": there are no samples");
  keep(lines, selected(times, source.selection, record.file));
  std::erase_if(record.lines.covariances, [&](const OrbitCovariance& covariance) {
    return covariance.epoch < source.selection.from.value_or(covariance.epoch) ||
           covariance.epoch > source.selection.until.value_or(covariance.epoch);
  });
  return record;
}

OrbitRecord relative_to_frame(OrbitRecord record, const std::string& reference,
                              const std::optional<EarthOrientation>& orientation) {
  detail::OrbitLines& lines = record.lines;
  const auto before = earth_frame_name(lines.ref_frame);
  if (!before)
    throw BadInput(record.file + ": the orbit is in '" + lines.ref_frame + "'; --frame turns " +
                   earth_frame_names() + " into each other");
  if (*before == reference) return record;
  if (!inertial(*before) || !inertial(reference)) require_turning(record, *before);
  const auto turn =
      turn_of_axes(*before, reference, from_until(lines.lines.front().time, lines.lines.back().time),
                   orientation, record.file);
  bool is_left_out = false;
  for (detail::OrbitLine& line : lines.lines) {
    const auto new_from_old = turn(line.time);
    const auto moved = coincident(new_from_old) * parallel(in_old_axes(line));
    line.position = moved.translation.coordinates();
    line.velocity = moved.velocity.coordinates();
    if (!line.acceleration) continue;
    if (inertial(*before) && inertial(reference)) {
      line.acceleration = new_from_old.rotation.matrix() * *line.acceleration;
    } else {
      line.acceleration.reset();
      is_left_out = true;
    }
  }
  for (OrbitCovariance& covariance : lines.covariances)
    if (covariance.ref_frame.empty()) covariance.ref_frame = lines.ref_frame;
  record.computed.push_back("the orbit is turned from " + *before + " to " + reference);
  if (is_left_out)
    record.computed.emplace_back("the accelerations, which axes that turn would change, are left out");
  lines.ref_frame = reference;
  return record;
}

}  // namespace vectrix::cli

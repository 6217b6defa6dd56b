#include "orbit_record.hpp"

#include <algorithm>

#include "message_kind.hpp"
#include "table_column.hpp"
#include "target.hpp"

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
  record.lines.ref_frame = columns.reference;
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

}  // namespace

OrbitRecord read_orbit_file(const OrbitFile& source) {
  OrbitFile named = source;
  if (named.columns) named.columns->reference = inertial_name(named.columns->reference);
  return read_orbit_in_any_frame(named);
}

OrbitRecord read_orbit_in_any_frame(const OrbitFile& source) {
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

OrbitRecord relative_to_frame(OrbitRecord record, const std::string& reference) {
  detail::OrbitLines& lines = record.lines;
  const auto before = inertial(lines.ref_frame);
  if (!before)
    throw BadInput(record.file + ": the orbit is in '" + lines.ref_frame +
                   "'; --frame turns EME2000 and GCRF into each other");
  if (*before == reference) return record;
  const Eigen::Matrix3d R_new_from_old = gcrf_from(reference).transpose() * gcrf_from(*before);
  for (detail::OrbitLine& line : lines.lines) {
    line.position = R_new_from_old * line.position;
    line.velocity = R_new_from_old * line.velocity;
    if (line.acceleration) line.acceleration = R_new_from_old * *line.acceleration;
  }
  for (OrbitCovariance& covariance : lines.covariances)
    if (covariance.ref_frame.empty()) covariance.ref_frame = lines.ref_frame;
  record.computed.push_back("the orbit is turned from " + *before + " to " + reference);
  lines.ref_frame = reference;
  return record;
}

}  // namespace vectrix::cli

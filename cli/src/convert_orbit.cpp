#include <algorithm>
#include <ostream>

#include "convert.hpp"
#include "earth_frame.hpp"
#include "figures.hpp"
#include "new_file.hpp"
#include "reference_frame.hpp"
#include "table_text.hpp"
#include "viewer_text.hpp"
#include "word.hpp"

namespace vectrix::cli {
namespace {

std::string orbit_table(const OrbitRecord& record) {
  const detail::OrbitLines& lines = record.lines;
  if (lines.ref_frame_epoch)
    throw BadInput(record.file + ": a table does not say that REF_FRAME_EPOCH stops " + lines.ref_frame);
  const bool accelerated = std::all_of(lines.lines.begin(), lines.lines.end(),
                                       [](const auto& line) { return line.acceleration.has_value(); });
  if (!accelerated && std::any_of(lines.lines.begin(), lines.lines.end(),
                                  [](const auto& line) { return line.acceleration.has_value(); }))
    throw BadInput(record.file +
                   ": some lines have an acceleration, others have none; a table has them for all");
  const std::string frame = inertial(lines.ref_frame).value_or(lines.ref_frame),
                    scale = small(record.time_scale.name()), time = "time_" + scale,
                    in = "_in_" + small(frame);
  const std::vector<std::string> position{"x" + in + "_m", "y" + in + "_m", "z" + in + "_m"},
      velocity{"vx" + in + "_m_per_s", "vy" + in + "_m_per_s", "vz" + in + "_m_per_s"},
      acceleration{"ax" + in + "_m_per_s2", "ay" + in + "_m_per_s2", "az" + in + "_m_per_s2"};
  std::string text = "# Orbit in " + frame + ", observed from it, from " + record.file + ".\n";
  if (record.message) {
    const EphemerisMetadata& metadata = record.message->metadata;
    text += "# Of " + metadata.object_name + " relative to the centre of " + metadata.center_name + ".\n";
  }
  const bool is_about_earth = !record.message || small(record.message->metadata.center_name) == "earth";
  if (earth_frame_name(frame) && is_about_earth)
    text += "# Options to read it: --time " + time + " --scale " + scale + " --position " + joined(position) +
            " --velocity " + joined(velocity) + " --unit m --reference " + frame + "\n";
  text += time + "," + joined(position) + "," + joined(velocity) +
          (accelerated ? "," + joined(acceleration) : "") + "\n";
  for (const detail::OrbitLine& line : lines.lines) {
    text += exact_text(line.time, record.time_scale);
    add_fields(text, line.position);
    add_fields(text, line.velocity);
    if (accelerated) add_fields(text, *line.acceleration);
    text += "\n";
  }
  return text;
}

std::string orbit_message(const OrbitRecord& record, const ConvertOptions& options, bool is_part) {
  MessageText text = message_text(options.text, record.message, record.time_scale, record.file, {});
  if (!record.message) {
    text.header.version = "2.0";
    text.metadata.center_name = "EARTH";  // of all frames of a table
  }
  if (options.interpolation) {
    text.metadata.interpolation = options.interpolation->method;
    text.metadata.interpolation_degree = options.interpolation->degree;
  }
  detail::OrbitLines lines = record.lines;
  if (!record.message || is_part)
    set_times(text.metadata, lines.lines.front().time, lines.lines.back().time, record.file);
  lines.place = "the message to be written";
  return text_that_reads_back(
      OrbitEphemerisMessage(text.header, {{detail::trusted, text.metadata, std::move(lines)}}), options.out);
}

std::vector<Epoch> times_of(const OrbitRecord& record) {
  std::vector<Epoch> times;
  for (const detail::OrbitLine& line : record.lines.lines) times.push_back(line.time);
  return times;
}

void require_orbit_name(const ConvertOptions& options, const std::filesystem::path& file) {
  if (!is_viewer_name(options.out)) (void)is_table_name(options.out, ".oem");
  if (ending_of(options.out) == ".a") throw BadInput(options.out.string() + ": .a is of an attitude");
  refuse_input(options.out, {file, options.orientation});
}

// `is_part`: not all of a message.
void write_orbit(OrbitRecord record, bool is_part, const ConvertOptions& options, std::ostream& out) {
  const bool is_for_viewer = is_viewer_name(options.out),
             is_table = !is_for_viewer && is_table_name(options.out, ".oem");
  const std::string frame = options.frame.empty() ? "" : stated_earth_frame("--frame", options.frame);
  if (!options.orientation.empty())
    require_observed(options.frame, earth_frame_name(record.lines.ref_frame).value_or(record.lines.ref_frame),
                     "the orbit is in ");
  if (!frame.empty()) {
    const auto orientation = read_orientation(options.orientation, times_of(record));
    record = relative_to_frame(std::move(record), frame, orientation);
  }
  write_new(options.out,
            is_for_viewer ? czml_orbit(record, object_name(options.text, record.message, record.file))
            : is_table    ? orbit_table(record)
                          : orbit_message(record, options, is_part),
            options.force);
  out << options.out.string() << ": " << record.lines.lines.size() << " samples of an orbit in "
      << record.lines.ref_frame << '\n';
  for (const std::string& what : record.computed) out << "  not to the last digit: " << what << '\n';
  if ((is_table || is_for_viewer) && !record.lines.covariances.empty())
    out << "  left out: " << counted(record.lines.covariances.size(), "covariance") << '\n';
}

}  // namespace

void convert(const OrbitFile& orbit, const ConvertOptions& options, std::ostream& out) {
  require_orbit_name(options, orbit.file);
  write_orbit(read_orbit_file(orbit), orbit.selection.from || orbit.selection.until, options, out);
}

void convert(const SampledOrbit& orbit, const ConvertOptions& options, std::ostream& out) {
  require_orbit_name(options, orbit.file);
  write_orbit(sampled(orbit), false, options, out);
}

}  // namespace vectrix::cli

#include <ostream>
#include <vector>

#include "convert.hpp"
#include "earth_frame.hpp"
#include "figures.hpp"
#include "kernel_writer.hpp"
#include "new_file.hpp"
#include "plain_attitude.hpp"
#include "quantile.hpp"
#include "reference_frame.hpp"
#include "sample_faults.hpp"
#include "table_text.hpp"
#include "viewer_text.hpp"
#include "word.hpp"

namespace vectrix::cli {
namespace {

std::string attitude_table(const PlainAttitude& attitude, const std::string& file) {
  const std::string reference = small(attitude.reference), scale = small(attitude.time_scale.name()),
                    axes = attitude.rate_axes == RateAxes::body ? "body" : "reference",
                    unit = attitude.rates_in_degrees ? "deg/s" : "rad/s";
  const std::string time = "time_" + scale, q = "q_" + reference + "_from_body_";
  const std::string w = "rate_in_" + (axes == "body" ? axes : reference) +
                        (attitude.rates_in_degrees ? "_deg_per_s_" : "_rad_per_s_");
  const std::vector<std::string> quaternion{q + "w", q + "x", q + "y", q + "z"},
      rate{w + "x", w + "y", w + "z"};
  std::string text = "# Attitude of " + attitude.body + " relative to " + attitude.reference + ", from " +
                     file + ".\n# R(q) of Hamilton's product takes coordinates from the body to " +
                     attitude.reference + ". The scalar, w, is first.\n# Options to read it: --time " + time +
                     " --scale " + scale + " --quaternion " + joined(quaternion) +
                     " --scalar first --maps reference --reference " + attitude.reference;
  if (!attitude.rates.empty())
    text += " --rates " + joined(rate) + " --rate-unit " + unit + " --rate-axes " + axes;
  text += "\n" + time + "," + joined(quaternion) + (attitude.rates.empty() ? "" : "," + joined(rate)) + "\n";
  for (std::size_t i = 0; i < attitude.times.size(); ++i) {
    text += exact_text(attitude.times[i], attitude.time_scale);
    add_fields(text, attitude.quaternions[i]);
    if (!attitude.rates.empty()) add_fields(text, attitude.rates[i]);
    text += "\n";
  }
  return text;
}

std::string attitude_message(const PlainAttitude& attitude, const MessageText& text,
                             const std::filesystem::path& out) {
  detail::AttitudeLines lines;
  lines.place = "the message to be written";
  lines.ref_frame_a = attitude.reference;
  lines.ref_frame_b = attitude.body;
  lines.times = attitude.times;
  lines.comments = text.comments;
  if (!attitude.rates.empty()) {
    lines.type = AttitudeType::quaternion_rate;
    lines.rate_frame =
        attitude.rate_axes == RateAxes::reference ? detail::RateFrame::a : detail::RateFrame::b;
  }
  for (std::size_t i = 0; i < attitude.times.size(); ++i) {
    const auto& q = attitude.quaternions[i];
    lines.numbers.insert(lines.numbers.end(), {q[1], q[2], q[3], q[0]});
    if (!attitude.rates.empty())
      lines.numbers.insert(lines.numbers.end(), attitude.rates[i].begin(), attitude.rates[i].end());
  }
  const AttitudeEphemerisMessage all(text.header, {{detail::trusted, text.metadata, std::move(lines)}});
  return text_that_reads_back(all, out);
}

}  // namespace

void convert(const AttitudeSource& source, const ConvertOptions& options, std::ostream& out) {
  const bool is_for_viewer = is_viewer_name(options.out), is_for_spice = is_kernel_name(options.out),
             is_table = !is_for_viewer && !is_for_spice && is_table_name(options.out, ".aem");
  refuse_input(options.out, files_of(source));
  refuse_input(options.out, files_of(AttitudeSource{{}, {}, {}, options.kernel}));
  require_one_line("--body", options.body);
  AttitudeRecord record = read_attitude(source);
  refuse_input(options.out, files_of(options.orbit));
  refuse_input(options.out, {options.orientation});
  const std::string frame = options.frame.empty() ? "" : stated_earth_frame("--frame", options.frame);
  const bool is_of_orbit = !earth_frame_name(record.reference);
  if (!files_of(options.orbit).empty() && (inertial(record.reference) || frame.empty()))
    throw BadInput(
        "an orbit is for --frame, of an attitude relative to a frame that moves; this one is relative to " +
        record.reference);
  if (!options.orientation.empty() && options.orbit.message.empty())
    require_observed(options.frame, record.reference, "the attitude is relative to ");
  const auto orientation = read_orientation(options.orientation, record.times);
  if (is_of_orbit && !frame.empty()) {
    OrbitSource orbit = options.orbit;
    orbit.orientation = orientation;
    turn_to_gcrf(record, read_orbit(orbit, from_until(record.times.front(), record.times.back())),
                 orientation, reference_options);
  }
  PlainAttitude attitude = plain(record);
  if (reference_name(options.body))
    throw BadInput("--body " + options.body + " is the name of a reference, not of a body");
  if (!options.body.empty()) attitude.body = options.body;
  if (!frame.empty() && frame != attitude.reference) {
    if (!inertial(frame) || !inertial(attitude.reference)) require_earth(record);
    attitude = turned(std::move(attitude), frame, orientation, record.file);
  }
  std::string text;
  if (is_for_spice) {
    attitude = as_in_a_kernel(std::move(attitude));
    KernelWords words = options.kernel;
    if (source.kernel && words.frame.empty()) words.frame = record.body;
    write_kernel(attitude, words, longest_step(record, median(durations_of(record))), options.out,
                 options.force);
  } else if (is_for_viewer) {
    require_earth(record);  // there the axes are at its centre
    if (!attitude.rates.empty()) attitude.computed.emplace_back("the rates are left out");
    if (!record.are_normalised) attitude.computed.emplace_back("the quaternions are divided by their norms");
    if (ending_of(options.out) == ".a") {
      text = stk_attitude(attitude);
    } else {
      const std::string object = object_name(options.text, record.message, record.file);
      text = czml_attitude(attitude, object);
      attitude.computed.emplace_back(
          "the attitude is turned to the axes of the Earth, with UT1 = UTC: 14 arcsec");
    }
  } else if (is_table) {
    text = attitude_table(attitude, record.file);
  } else {
    attitude = as_in_a_message(std::move(attitude));
    const Words body = record.names_body ? Words{} : Words{{"--body FRAME", options.body}};
    MessageText words = message_text(options.text, record.message, record.time_scale, record.file, body);
    words.header.version = options.aem_version;
    if (!record.message || source.selection.from || source.selection.until)
      set_times(words.metadata, attitude.times.front(), attitude.times.back(), record.file);
    text = attitude_message(attitude, words, options.out);
  }
  if (!is_for_spice) write_new(options.out, text, options.force);
  out << options.out.string() << ": " << attitude.times.size() << " samples of " << attitude.body
      << " relative to " << attitude.reference << '\n';
  for (const std::string& what : attitude.computed) out << "  not to the last digit: " << what << '\n';
  if (!record.chain.empty()) out << "  multiplied from what the kernel has: " << record.chain << '\n';
  if (const std::size_t breaks = faults_of(record).breaks.count; breaks > 0)
    out << "  left out: " << counted(breaks, "end")
        << " of intervals, behind which nothing is interpolated\n";
  if (!record.hidden_segments.empty())
    out << "  left out, for later segments of the kernel hide it: " << record.hidden_segments << '\n';
  if (const std::size_t gaps = is_for_viewer ? faults_of(record).gaps.count : 0; gaps > 0)
    out << "  not marked: " << counted(gaps, "gap") << ", over which a viewer turns\n";
}

}  // namespace vectrix::cli

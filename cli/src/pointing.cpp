#include "pointing.hpp"

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "angle_figures.hpp"
#include "earth_frame.hpp"
#include "figures.hpp"
#include "hidden.hpp"
#include "new_file.hpp"
#include "pointing_error.hpp"
#include "reference_frame.hpp"
#include "sample_faults.hpp"
#include "sunlight.hpp"
#include "word.hpp"

namespace vectrix::cli {
namespace {

// "the Sun, apparent, seen from the satellite"
std::string seen(const PointingOptions& options, bool from_orbit) {
  const std::string target = name_of(options.target);
  if (!options.correction) return target;
  return target + ", " + words_of(*options.correction) + ", seen from " +
         (from_orbit ? "the satellite" : "the centre of the Earth");
}

void write(const AngleFigures& figures, const std::vector<Epoch>& times, std::ostream& out) {
  const auto figure = [](const char* name, double angle) {
    return label(name, 12) + padded(decimals(angle), 12);
  };
  const auto line = [&](const char* name, std::size_t place) {
    out << figure(name, figures.value(place)) << "   at " << times[place].utc(3) << " UTC\n";
  };
  line("least", figures.place_of_least());
  line("median", figures.place_of(50.0));
  line("95 %", figures.place_of(95.0));
  line("largest", figures.place_of_largest());
  out << figure("rms", figures.rms()) << '\n';
}

bool fulfils(const AngleFigures& figures, double required, double percent, const char* what,
             std::ostream& out) {
  const Judgement judged = figures.judge(required, percent);
  out << "  Required: at most " << detail::text(required) << " deg in " << detail::text(percent)
      << " % of the " << what << ". It is " << decimals(judged.found) << " deg, margin "
      << decimals(judged.margin) << " deg; " << judged.within << " of " << figures.size()
      << " are within.\n  " << (judged.fulfilled ? "Fulfilled.\n" : "Not fulfilled.\n");
  return judged.fulfilled;
}

std::string table(const PointingOptions& options, const AttitudeRecord& record, const std::string& target,
                  const std::vector<double>& angles, const std::vector<bool>& hidden) {
  std::string text = "# Angle between the axis (" + detail::text(options.axis.x()) + ", " +
                     detail::text(options.axis.y()) + ", " + detail::text(options.axis.z()) + ") of " +
                     record.body + " and " + target + ".\n# Attitude of " + record.body + " relative to " +
                     record.reference_of_file() + " from " + record.file +
                     ". Times in UTC, angles in degrees" +
                     (hidden.empty() ? ".\ntime_utc,angle_deg\n"
                                     : "; hidden: 1 if the Earth hides it.\ntime_utc,angle_deg,hidden\n");
  for (std::size_t i = 0; i < angles.size(); ++i)
    text += exact_text(record.times[i], scale::utc) + "," + detail::text(degrees * angles[i]) +
            (hidden.empty() ? "\n"
             : hidden[i]    ? ",1\n"
                            : ",0\n");
  return text;
}

void require_angle(const char* option, const std::optional<double>& angle) {
  if (angle && !(*angle > 0.0 && *angle <= 180.0))
    throw BadInput(std::string(option) + ' ' + detail::text(*angle) +
                   " is no angle above 0 and at most 180 degrees");
}

void check_options(const PointingOptions& options) {
  require_axis(options.axis);
  const auto possible = corrections_of(options.target);
  const std::string names = joined(possible, "|");
  if (!possible.empty() && !options.correction)
    throw BadInput(name_of(options.target) + " is not where it is seen; missing: --correction " + names);
  if (possible.empty() && options.correction)
    throw BadInput("--correction is of the Sun, the Moon and stars, not of " + name_of(options.target));
  if (std::holds_alternative<StarTarget>(options.target) &&
      std::holds_alternative<Geometric>(*options.correction))
    throw BadInput("a catalogue says where a star is seen, not where it is; needed: --correction " + names);
  const bool is_station = std::holds_alternative<StationTarget>(options.target);
  if (is_station && options.orientation.empty())
    throw BadInput(name_of(options.target) +
                   " turns with the Earth; missing: --orientation FILE, finals2000A of the IERS");
  if (options.force && options.csv.empty())
    throw BadInput("--force overwrites the file of --csv, which is not given");
  require_angle("--require", options.required);
  require_angle("--require-relative", options.required_relative);
  if ((options.required || options.required_relative) != options.percent.has_value())
    throw BadInput(
        "--percent, how many of the samples have to fulfil it, goes with --require or --require-relative");
  if (options.percent && !(*options.percent > 0.0 && *options.percent <= 100.0))
    throw BadInput("--percent " + detail::text(*options.percent) + " is not above 0 and at most 100");
  if (options.required_relative && !options.window)
    throw BadInput("--require-relative needs the window of the relative error; missing: --window SECONDS");
  if (options.window && !(*options.window > 0.0 && std::isfinite(*options.window)))
    throw BadInput("--window " + detail::text(*options.window) + " is no duration");
}

// The figures name their instants in UTC.
void require_utc(const AttitudeRecord& record) {
  if (record.times.front() < Epoch::from_utc("1960-01-01T00:00:00"))
    throw BadInput(record.file + ": the first sample, " + record.times.front().tt(3) +
                   " TT, is before 1960, and UTC, in which the figures are written, is not known then");
}

// The angles are of those samples that count.
void write_hidden(const std::vector<double>& angles, const std::vector<bool>& hidden, bool are_all,
                  std::ostream& out) {
  const std::string words = words_of_hidden(hidden, "sample");
  if (words.empty()) return;
  std::vector<bool> visible = hidden;
  visible.flip();
  const auto seen = counted_of(angles, visible);
  out << "  These are of all " << (are_all ? "samples" : "the others") << ", but " << words;
  if (!seen.empty()) {
    const AngleFigures figures(seen);
    out << ";\n  at the others the angle is " << decimals(figures.value(figures.place_of_least())) << " to "
        << decimals(figures.value(figures.place_of_largest())) << " deg";
  }
  out << ".\n";
}

bool write_absolute(const PointingOptions& options, const AttitudeRecord& record, const std::string& target,
                    const std::vector<double>& all, const std::vector<bool>& hidden,
                    const std::vector<bool>& counts, std::ostream& out) {
  out << "Absolute error, deg: the angle between the axis " << name_of(options.axis) << " of " << record.body
      << "\nand " << target << '\n';
  const auto angles = counted_of(all, counts);
  const AngleFigures figures(angles);
  write(figures, counted_of(record.times, counts), out);
  if (const std::string words = words_of_left_out(options.when, counts, "sample"); !words.empty())
    out << "  " << words << ".\n";
  if (options.when != When::visible) write_hidden(angles, counted_of(hidden, counts), counts.empty(), out);
  return !options.required || fulfils(figures, *options.required, *options.percent, "samples", out);
}

bool write_relative(const PointingOptions& options, const AttitudeRecord& record, const RelativeErrors& found,
                    std::ostream& out) {
  std::vector<Epoch> starts;
  for (const std::size_t i : found.starts) starts.push_back(record.times[i]);
  out << "\nRelative error, deg: the most that the target moves from its mean direction in a window of "
      << detail::text(*options.window) << " s,\n"
      << counted(found.errors.size(), "window") << "; " << found.left_out
      << (found.left_out == 1 ? " more reaches" : " more reach") << " over a gap"
      << (options.when == When::always ? "" : ", a sample that is left out,") << " or the end\n";
  const AngleFigures figures(found.errors);
  write(figures, starts, out);
  out << "  The largest change between two samples at most " << detail::text(*options.window)
      << " s apart is " << decimals(degrees * found.largest_change) << " deg,\n  from "
      << record.times[found.change_from].utc(3) << " UTC to " << record.times[found.change_until].utc(3)
      << " UTC.\n";
  return !options.required_relative ||
         fulfils(figures, *options.required_relative, *options.percent, "windows", out);
}

}  // namespace

bool pointing(const PointingOptions& options, std::ostream& out) {
  check_options(options);
  for (const auto& inputs : {files_of(options.attitude), files_of(options.orbit)})
    refuse_input(options.csv, inputs);
  refuse_input(options.csv, {options.orientation});
  AttitudeRecord record = read_attitude(options.attitude);
  require_utc(record);
  if (!options.orientation.empty() && !std::holds_alternative<StationTarget>(options.target) &&
      !is_observed(record.reference) && options.orbit.message.empty())
    throw BadInput("--orientation is of a station and of ITRF, TIRF and CIRF; the target is " +
                   name_of(options.target) + ", the attitude is relative to " + record.reference +
                   ", and there is no --oem");
  OrbitSource source = options.orbit;
  source.orientation = read_orientation(options.orientation, record.times);
  const FlownOrbit orbit = read_orbit(source, from_until(record.times.front(), record.times.back()));
  require_orbit_for(options.target, orbit);
  turn_to_gcrf(record, orbit, source.orientation, reference_options);
  require_known(options.when, options.target, static_cast<bool>(orbit), "--tle, --omm, --oem or --spk");
  const auto motions = motions_at(record.times, orbit);
  const auto lines = lines_to(options.target, record.times, motions, options.correction.value_or(geometric),
                              source.orientation);
  const auto hidden = hidden_by_earth(options.target, record.times, motions, static_cast<bool>(orbit), lines,
                                      source.orientation);
  const auto in_body = seen_in_body(record, directions_of(lines, record, name_of(options.target)));
  const auto angles = absolute_errors(in_body, options.axis);
  const auto counts = counting(options.when, hidden,
                               options.when == When::sunlight || options.when == When::shadow
                                   ? visible_suns(record.times, motions)
                                   : std::vector<double>{},
                               name_of(options.target));
  std::optional<RelativeErrors> relative;
  if (options.window) relative = relative_errors(record, in_body, *options.window, counts);
  const std::string target = seen(options, static_cast<bool>(orbit));

  if (!options.csv.empty())
    write_new(options.csv, table(options, record, target, angles, hidden), options.force);
  write_samples(record, out);
  bool good = write_absolute(options, record, target, angles, hidden, counts, out);
  if (relative) good = write_relative(options, record, *relative, out) && good;
  return good;
}

}  // namespace vectrix::cli

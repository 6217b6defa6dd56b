#include "check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <ostream>
#include <string>

#include "sample_faults.hpp"

namespace vectrix::cli {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;  // per radian

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}
std::string padded(std::string text, std::size_t width) {
  text.insert(0, width - std::min(width, text.size()), ' ');
  return text;
}
std::string label(std::string_view name) {
  std::string text = "  " + std::string(name);
  text.resize(std::max<std::size_t>(text.size(), 30), ' ');
  return text;
}

std::string axes_name(RateAxes axes, const AttitudeRecord& record) {
  return axes == RateAxes::body ? record.body : record.reference;
}

// The comparisons made so far, and what they say together.
class Findings {
 public:
  explicit Findings(std::ostream& out) : out_(out) {}

  void add(Verdict found, const std::string& better) {
    if (found == Verdict::as_stated) {
      ++confirmed_;
      out_ << "  The file as stated fits, three times better than any other reading.\n\n";
    } else if (found == Verdict::another) {
      ++refuted_;
      out_ << "  Another reading fits three times better: " << better << ".\n\n";
    } else {
      out_ << "  This decides nothing.\n\n";
    }
  }
  [[nodiscard]] bool conclude() const {
    if (refuted_ > 0) {
      out_ << "The file as stated does not fit.\n";
    } else if (confirmed_ > 0) {
      out_ << "The file as stated fits.\n";
    } else {
      out_ << "Not decided: nothing here tells the readings apart. Rates (--rates), an orbit (--tle, --oem) or a\n"
              "target (--axis, --target) may.\n";
    }
    return refuted_ == 0 && confirmed_ > 0;
  }

 private:
  std::ostream& out_;
  int confirmed_ = 0, refuted_ = 0;
};

std::size_t best_of(const std::vector<double>& values) {
  return static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
}

void write_head(const AttitudeRecord& record, const SampleFaults& faults, std::ostream& out) {
  out << record.file << "\n" << record.size() << " samples of " << record.body << " relative to "
      << record.reference << ", " << record.times.front() << " to " << record.times.back() << ", usually "
      << shown(faults.median_step) << " s apart.\n";
  if (record.has_quaternions) {
    const bool to_body = record.stated.maps == Convention::Maps::to_body;
    out << "As stated, R(q) takes coordinates to " << (to_body ? record.body : record.reference)
        << "; the scalar is " << (record.stated.scalar == Convention::Scalar::first ? "first" : "last")
        << ".\n";
  }
  out << '\n';
}

void write_faults(const AttitudeRecord& record, const SampleFaults& faults, std::ostream& out) {
  out << "Samples\n";
  const auto at = [&](std::size_t sample) {
    return "sample " + detail::text(sample + 1) + ", " + record.times[sample].utc(3) + " UTC";
  };
  const auto line = [&](const SampleFaults::Extreme& found, const std::string& what, const std::string& largest) {
    if (found.count > 0)
      out << "  " << found.count << ' ' << what << (largest.empty() ? ", first" : "; most " + largest) << " at "
          << at(found.sample) << '\n';
  };
  line(faults.gaps, "gaps, steps longer than three times the usual one", shown(faults.gaps.largest) + " s, which ends");
  line(faults.sign_flips, "changes from q to -q: the attitude is one, its numbers are not", "");
  line(faults.half_turns, "steps near half a turn: rates must say which way it turned",
       shown(degrees * faults.half_turns.largest) + " deg");
  line(faults.jumps, "jumps, ten times faster than usual", shown(degrees * faults.jumps.largest) + " deg");
  line(faults.norm_errors, "quaternions whose norm is off the median norm by more than 1e-6",
       shown(faults.norm_errors.largest) + " of it");
  if (std::abs(faults.scale - 1.0) > 1e-6)
    out << "  the norm of the quaternions is " << shown(faults.scale) << ", not 1\n";
  if (faults.gaps.count + faults.sign_flips.count + faults.half_turns.count + faults.jumps.count +
          faults.norm_errors.count ==
      0)
    out << "  no gaps, changes of sign, half turns, jumps or doubtful norms\n";
  out << '\n';
}

void write_rates(const AttitudeRecord& record, Findings& findings, std::ostream& out) {
  const auto evidence = compare_rates(record);
  const RateAxes stated = record.rate_axes;
  const RateAxes other = stated == RateAxes::body ? RateAxes::reference : RateAxes::body;
  out << "Rates less the turns of the attitude, deg/s rms; the rates are " << shown(degrees * evidence.rms_rate)
      << " deg/s rms\n"
      << label("rates in the axes of") << padded(axes_name(stated, record), 14)
      << padded(axes_name(other, record), 14) << '\n';
  const auto readings = readings_of(record);
  for (std::size_t i = 0; i < readings.size(); ++i)
    out << label(readings[i].name()) << padded(shown(degrees * evidence.stated_axes[i]), 14)
        << padded(shown(degrees * evidence.other_axes[i]), 14) << '\n';
  std::vector<double> all = evidence.stated_axes;
  all.insert(all.end(), evidence.other_axes.begin(), evidence.other_axes.end());
  const std::size_t best = best_of(all);
  const auto name = std::string(readings[best % readings.size()].name()) + ", rates in the axes of " +
                    axes_name(best < readings.size() ? stated : other, record);
  const Verdict found = verdict(all, evidence.rms_rate / 3.0);
  const auto turned = found == Verdict::undecided ? axes_of_rates(record) : std::nullopt;
  if (!turned) {
    findings.add(found, name);
    return;
  }
  const auto axis = [&](std::size_t i) {
    const int along = turned->axes[i];
    return std::string(along < 0 ? "-" : "") + "xyz"[std::abs(along) - 1];
  };
  findings.add(Verdict::another, std::string(turned->reading.name()) + ", with x, y, z of the rates along " + axis(0) +
                                     ", " + axis(1) + ", " + axis(2) + " of " + record.body + ", " +
                                     shown(degrees * turned->difference) + " deg/s");
}

void write_angles(const AttitudeRecord& record, const std::vector<double>& found, const std::string& title,
                  double useless, Findings& findings, std::ostream& out) {
  out << title << '\n';
  const auto readings = readings_of(record);
  for (std::size_t i = 0; i < readings.size(); ++i)
    out << label(readings[i].name()) << padded(shown(degrees * found[i]), 14) << '\n';
  findings.add(verdict(found, useless), std::string(readings[best_of(found)].name()));
}

AttitudeRecord read(const CheckOptions& options) {
  return options.columns ? read_table(options.file, *options.columns)
                         : read_message(options.file, options.segment);
}

FlownOrbit orbit_of(const CheckOptions& options, const TimeSpan& span) {
  if (!options.elements.empty() && !options.orbit.empty())
    throw BadInput("two orbits are given, --tle " + options.elements.string() + " and --oem " +
                   options.orbit.string());
  if (!options.elements.empty()) return orbit_of_elements(options.elements, span);
  if (!options.orbit.empty()) return orbit_of_message(options.orbit, span);
  return nullptr;
}

void require_axis(const Eigen::Vector3d& axis) {
  if (!axis.allFinite() || !(axis.norm() > 0.0) || !std::isfinite(axis.norm()))
    throw BadInput("--axis (" + detail::text(axis.x()) + ", " + detail::text(axis.y()) + ", " +
                   detail::text(axis.z()) + ") has no direction");
}

std::string name_of(Target target) {
  if (target == Target::sun) return "the Sun";
  return target == Target::moon ? "the Moon" : "the centre of the Earth";
}

}  // namespace

bool check(const CheckOptions& options, std::ostream& out) {
  if (options.axis.has_value() != options.target.has_value())
    throw BadInput("--axis and --target go together: an axis of the body, and what it should look at");
  if (options.axis) require_axis(*options.axis);
  const AttitudeRecord record = read(options);
  const auto span = from_until(record.times.front(), record.times.back());
  const FlownOrbit orbit = orbit_of(options, span);
  if (options.target && *options.target != Target::sun && !orbit)
    throw BadInput("the direction of " + name_of(*options.target) + " needs an orbit: --tle or --oem");

  const SampleFaults faults = faults_of(record);
  write_head(record, faults, out);
  write_faults(record, faults, out);
  Findings findings(out);
  if (!record.rates.empty()) write_rates(record, findings, out);
  if (!record.no_rates.empty()) out << record.no_rates << "\n\n";
  if (orbit) {
    // Half the rate of a low orbit: what turns faster does not keep an attitude relative to LVLH.
    constexpr double useless = 5e-4;
    write_angles(record, steadiness(record, orbit), "Rate relative to LVLH, deg/s rms", useless, findings, out);
  }
  if (options.target) {
    const auto& a = *options.axis;
    constexpr double useless = std::numbers::pi / 4.0;
    write_angles(record, off_target(record, a, *options.target, orbit),
                 "Median angle between the axis (" + shown(a.x()) + ", " + shown(a.y()) + ", " + shown(a.z()) +
                     ") of " + record.body + " and " + name_of(*options.target) + ", deg",
                 useless, findings, out);
  }
  return findings.conclude();
}

}  // namespace vectrix::cli

#include "check.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "earth_frame.hpp"
#include "evidence.hpp"
#include "figures.hpp"
#include "other_scales.hpp"
#include "reference_frame.hpp"
#include "sample_faults.hpp"

namespace vectrix::cli {
namespace {

std::string axes_name(RateAxes axes, const AttitudeRecord& record) {
  return axes == RateAxes::body ? record.body : record.reference_of_file();
}

// A comparison, and what it found of each reading, the stated one first; of rates, of each in the stated axes
// and then of each in the other ones.
struct Comparison {
  std::vector<std::string> names;
  std::vector<double> disagreements;
  double largest;             // a larger one is no fit
  std::string without_fit{};  // what to say then
  bool is_needed = false;     // then no fit contradicts the file
};

// What was compared, of what may decide.
struct Compared {
  bool rates, orbit, target;
};

std::string what_may_decide(const Compared& compared) {
  std::vector<std::string> missing;
  if (!compared.rates) missing.emplace_back("rates (--rates)");
  if (!compared.orbit) missing.emplace_back("an orbit (--tle, --omm, --oem, --spk)");
  if (!compared.target) missing.emplace_back("a target (--axis, --target)");
  std::string text;
  for (std::size_t i = 0; i < missing.size(); ++i)
    text += (i == 0 ? "" : i + 1 == missing.size() ? " or " : ", ") + missing[i];
  if (text.empty()) return "";
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return " " + text + " may decide.";
}

// The comparisons made so far, and what they say together.
class Findings {
 public:
  Findings(std::size_t readings, std::ostream& out) : out_(out), readings_(readings) {}

  void add(const Comparison& made) {
    const auto fit = fitting(made.disagreements, made.largest);
    keep(made, fit);
    if (fit.empty()) {
      contradicts_itself_ = contradicts_itself_ || made.is_needed;
      out_ << "  No reading fits." << made.without_fit << "\n\n";
    } else if (fit.front() != 0) {
      ++refuted_;
      out_ << "  Another reading fits, three times better than as stated: " << names(made, fit, 0) << ".\n\n";
    } else if (fit.size() == 1) {
      ++confirmed_;
      out_ << "  The file as stated fits, three times better than any other reading.\n\n";
    } else {
      out_ << "  The file as stated fits, but this does not tell it from: " << names(made, fit, 1) << ".\n\n";
    }
  }
  void add_refusal(const std::string& better) {
    ++refuted_;
    fit_.emplace_back();  // by none of these readings
    out_ << "  Another reading fits: " << better << ".\n\n";
  }
  // As stated, but for the scale of the times.
  void add_scales(const std::string& better, const char* stated) {
    scales_ = better;
    out_ << "  Another reading fits: as stated, times in " << better << ", which the file states in "
         << stated << ".\n\n";
  }
  [[nodiscard]] bool conclude(const Compared& compared) const {
    const std::string common = in_common();
    if (refuted_ > 0 && !common.empty()) {
      out_ << "The file as stated does not fit. One reading fits all comparisons: " << common << ".\n";
    } else if (refuted_ > 0 && confirmed_ > 0) {
      out_ << "The comparisons contradict each other: one confirms the file as stated, one does not.\n";
    } else if (contradicts_itself_) {
      out_ << "The file as stated does not fit: the rates contradict it.\n";
    } else if (refuted_ > 0) {
      out_ << "The file as stated does not fit.\n";
    } else if (!scales_.empty()) {
      out_ << "The file as stated does not fit: with its times in " << scales_ << " it does.\n";
    } else if (confirmed_ > 0) {
      out_ << "The file as stated fits.\n";
      if (!compared.orbit && !compared.target)
        out_ << "Rates alone do not see a transposed file whose rates are those of the reference relative to "
                "the body:\n"
                "an orbit or a target would.\n";
    } else {
      out_ << "Not decided." << what_may_decide(compared) << '\n';
    }
    return refuted_ == 0 && !contradicts_itself_ && scales_.empty() && confirmed_ > 0;
  }

 private:
  void keep(const Comparison& made, const std::vector<std::size_t>& fit) {
    std::map<std::size_t, std::string> found;
    for (const std::size_t i : fit) {
      std::string& name = found[i % readings_];
      name += (name.empty() ? "" : " or ") + made.names[i];
    }
    fit_.push_back(std::move(found));
  }
  // The one reading that is in all of several comparisons, by its longest name, which has the axes of the
  // rates; "" if there is none, or more.
  [[nodiscard]] std::string in_common() const {
    std::string only;
    std::size_t count = 0;
    if (fit_.size() < 2) return "";
    for (const auto& [reading, name] : fit_.front()) {
      std::string longest;
      for (const auto& each : fit_) {
        const auto there = each.find(reading);
        if (there == each.end()) {
          longest.clear();
          break;
        }
        if (there->second.size() > longest.size()) longest = there->second;
      }
      if (longest.empty()) continue;
      only = longest;
      ++count;
    }
    return count == 1 ? only : "";
  }
  static std::string names(const Comparison& made, const std::vector<std::size_t>& fit, std::size_t from) {
    std::string list;
    for (std::size_t i = from; i < fit.size(); ++i)
      list += (i == from ? "" : i + 1 == fit.size() ? " or " : ", ") + made.names[fit[i]];
    return list;
  }

  std::ostream& out_;
  std::size_t readings_;
  std::vector<std::map<std::size_t, std::string>> fit_{};  // of each comparison, by reading
  int confirmed_ = 0, refuted_ = 0;
  bool contradicts_itself_ = false;
  std::string scales_{};  // those of the times that fit better than the stated one
};

std::string percent_of(double part, double whole) {
  return shown(100.0 * part / whole) + " %";
}

// Where the axes of the rates are in the body, if there is one way only.
std::optional<std::string> other_axes_of(const AttitudeRecord& record, double largest) {
  const auto tried = rates_in_other_axes(record);
  std::vector<double> differences;
  for (const auto& each : tried) differences.push_back(each.difference);
  if (fitting(differences, largest).size() != 1) return std::nullopt;
  const auto& best = tried.front();
  const auto axis = [&](std::size_t i) {
    return std::string(best.axes[i] < 0 ? "-" : "") + "xyz"[std::abs(best.axes[i]) - 1];
  };
  return std::string(best.reading.name()) + ", with x, y, z of the rates along " + axis(0) + ", " + axis(1) +
         ", " + axis(2) + " of " + record.body + ", " + shown(degrees * best.difference) + " deg/s";
}

// A frequent mistake: the attitude is relative to a frame that turns, and the rates are relative to GCRF.
void write_rates_of_gcrf(const AttitudeRecord& record, const RateEvidence& evidence,
                         std::vector<std::string>& names, std::ostream& out) {
  const auto readings = readings_of(record);
  out << label("relative to GCRF, in axes of") << padded(record.body, 14) << padded("GCRF", 14) << '\n';
  for (std::size_t i = 0; i < readings.size(); ++i)
    out << label(readings[i].name()) << padded(shown(degrees * evidence.of_gcrf_in_body[i]), 14)
        << padded(shown(degrees * evidence.of_gcrf_in_gcrf[i]), 14) << '\n';
  for (const std::string& axes : {record.body, std::string("GCRF")})
    for (const Reading& reading : readings)
      names.push_back(std::string(reading.name()) + ", rates relative to GCRF in the axes of " + axes);
}

void write_rates(const AttitudeRecord& record, Findings& findings, std::ostream& out) {
  const auto evidence = compare_rates(record);
  const RateAxes stated = record.rate_axes;
  out << "Rates less the turns of the attitude, deg/s rms; the rates are "
      << shown(degrees * evidence.rms_rate) << " deg/s rms\n"
      << label("rates in the axes of") << padded(axes_name(stated, record), 14)
      << padded(axes_name(other(stated), record), 14) << '\n';
  constexpr double largest_part = 0.1;  // of the rates
  Comparison made{{}, evidence.stated_axes, largest_part * evidence.rms_rate};
  const bool is_beyond_change = evidence.least_beyond_change > made.largest;
  made.is_needed = is_beyond_change && evidence.least_lasting > made.largest;
  for (const auto* const more : {&evidence.other_axes, &evidence.of_gcrf_in_body, &evidence.of_gcrf_in_gcrf})
    made.disagreements.insert(made.disagreements.end(), more->begin(), more->end());
  const auto readings = readings_of(record);
  for (std::size_t i = 0; i < readings.size(); ++i)
    out << label(readings[i].name()) << padded(shown(degrees * evidence.stated_axes[i]), 14)
        << padded(shown(degrees * evidence.other_axes[i]), 14) << '\n';
  for (const RateAxes axes : {stated, other(stated)})
    for (const Reading& reading : readings)
      made.names.push_back(std::string(reading.name()) + ", rates in the axes of " + axes_name(axes, record));
  if (!evidence.of_gcrf_in_body.empty()) write_rates_of_gcrf(record, evidence, made.names, out);
  if (fitting(made.disagreements, made.largest).empty()) {
    const double best = *std::min_element(made.disagreements.begin(), made.disagreements.end());
    if (const auto better = other_axes_of(record, made.largest)) {
      findings.add_refusal(*better);
      return;
    }
    made.without_fit = evidence.rms_rate > 0.0
                           ? " The nearest leaves " + percent_of(best, evidence.rms_rate) + " of the rates."
                           : std::string(" The rates are zero, and the ") +
                                 (made.is_needed ? "body turns." : "attitude is not at rest.");
    if (!is_beyond_change) {
      made.without_fit += " They change too much from one sample to the next to contradict the file.";
    } else if (!made.is_needed) {
      made.without_fit +=
          " But it does not last from sample to sample: errors of the attitudes do that, and no reading.";
    }
    const double per_radian = evidence.rms_turn / evidence.rms_rate;
    for (const double factor : {degrees, 1.0 / degrees})
      if (std::abs(per_radian / factor - 1.0) < 0.05)
        made.without_fit += " The turns are " + shown(per_radian) + " times the rates: degrees for radians?";
  }
  findings.add(made);
}

// Those of other time scales under which the target is clearly nearer, the nearest first.
std::vector<ScaleReading> nearer_in_other_scales(const AttitudeRecord& as_read, double as_stated,
                                                 const std::function<double(AttitudeRecord)>& measured) {
  std::vector<ScaleReading> found = in_other_scales(as_read, measured);
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.angle < b.angle; });
  std::vector<double> angles{as_stated};
  for (const ScaleReading& each : found) angles.push_back(each.angle);
  const auto fit = fitting(angles, largest_off_target);
  if (fit.empty() || fit.front() == 0) return {};
  found.resize(fit.size());  // they are sorted
  return found;
}

// The readings, or else, if it is the stated one that fits best, those of the times.
void write_angles(const AttitudeRecord& record, const std::vector<double>& found, const std::string& title,
                  double largest, const std::vector<ScaleReading>& scales, Findings& findings,
                  std::ostream& out) {
  out << title << '\n';
  Comparison made{{}, found, largest};
  const auto readings = readings_of(record);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    out << label(readings[i].name()) << padded(shown(degrees * found[i]), 14) << '\n';
    made.names.emplace_back(readings[i].name());
  }
  std::string better;
  for (const ScaleReading& each : scales) {
    out << label(std::string("as stated, times in ") + each.scale) << padded(shown(degrees * each.angle), 14)
        << '\n';
    better += (better.empty() ? "" : " or ") + std::string(each.scale);
  }
  if (better.empty()) {
    findings.add(made);
  } else {
    findings.add_scales(better, record.time_scale.name());
  }
}

}  // namespace

bool check(const CheckOptions& options, std::ostream& out) {
  if (options.axis.has_value() != options.target.has_value())
    throw BadInput("--axis and --target go together: an axis of the body, and what it should look at");
  if (options.axis) require_axis(*options.axis);
  AttitudeRecord record = read_attitude(options.attitude);
  if (!options.orientation.empty() && !is_observed(record.reference) && options.orbit.message.empty())
    throw BadInput("--orientation is of ITRF, TIRF and CIRF; the attitude is relative to " +
                   record.reference + ", and there is no --oem");
  const auto span = from_until(record.times.front(), record.times.back());
  OrbitSource source = options.orbit;
  source.orientation = read_orientation(options.orientation, record.times);
  const FlownOrbit orbit = read_orbit(source, span);
  if (options.target) require_orbit_for(*options.target, orbit);
  const AttitudeRecord as_read = record;
  if (orbit || options.target) turn_to_gcrf(record, orbit, source.orientation, reference_options);

  // Written at the end: an input may be refused on the way.
  std::ostringstream text;
  write_samples(record, text);
  Findings findings(readings_of(record).size(), text);
  if (!record.rates.empty()) write_rates(record, findings, text);
  if (!record.no_rates.empty()) text << record.no_rates << "\n\n";
  if (orbit) {
    // Half the rate of a low orbit: what turns faster does not keep an attitude relative to LVLH.
    constexpr double largest = 5e-4;
    write_angles(record, steadiness(record, orbit), "Rate relative to LVLH, deg/s rms", largest, {}, findings,
                 text);
  }
  if (options.target) {
    const auto& a = *options.axis;
    const auto found = off_target(record, a, *options.target, orbit);
    const auto measured = [&](AttitudeRecord other) {
      turn_to_gcrf(other, orbit, source.orientation, reference_options);
      return off_target(other, a, *options.target, orbit).front();
    };
    std::vector<ScaleReading> scales;
    if (!options.attitude.kernel && found.front() == *std::min_element(found.begin(), found.end()))
      scales = nearer_in_other_scales(as_read, found.front(), measured);
    write_angles(record, found,
                 "Median angle between the axis " + name_of(a) + " of " + record.body + " and " +
                     name_of(*options.target) + ", deg",
                 largest_off_target, scales, findings, text);
  }
  const bool fits =
      findings.conclude({!record.rates.empty(), static_cast<bool>(orbit), options.target.has_value()});
  out << text.str();
  return fits;
}

}  // namespace vectrix::cli

#include "check.hpp"

#include <algorithm>
#include <cstdlib>
#include <numbers>
#include <ostream>
#include <string>

#include "evidence.hpp"
#include "figures.hpp"
#include "sample_faults.hpp"

namespace vectrix::cli {
namespace {

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
      out_ << "Not decided: nothing here tells the readings apart. Rates (--rates), an orbit (--tle, --oem) "
              "or a\n"
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

void write_rates(const AttitudeRecord& record, Findings& findings, std::ostream& out) {
  const auto evidence = compare_rates(record);
  const RateAxes stated = record.rate_axes;
  const RateAxes other = stated == RateAxes::body ? RateAxes::reference : RateAxes::body;
  out << "Rates less the turns of the attitude, deg/s rms; the rates are "
      << shown(degrees * evidence.rms_rate) << " deg/s rms\n"
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
  findings.add(Verdict::another, std::string(turned->reading.name()) + ", with x, y, z of the rates along " +
                                     axis(0) + ", " + axis(1) + ", " + axis(2) + " of " + record.body + ", " +
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

}  // namespace

bool check(const CheckOptions& options, std::ostream& out) {
  if (options.axis.has_value() != options.target.has_value())
    throw BadInput("--axis and --target go together: an axis of the body, and what it should look at");
  if (options.axis) require_axis(*options.axis);
  const AttitudeRecord record = read_attitude(options.attitude);
  const auto span = from_until(record.times.front(), record.times.back());
  const FlownOrbit orbit = read_orbit(options.orbit, span);
  if (options.target) require_orbit_for(*options.target, orbit);

  write_samples(record, out);
  Findings findings(out);
  if (!record.rates.empty()) write_rates(record, findings, out);
  if (!record.no_rates.empty()) out << record.no_rates << "\n\n";
  if (orbit) {
    // Half the rate of a low orbit: what turns faster does not keep an attitude relative to LVLH.
    constexpr double useless = 5e-4;
    write_angles(record, steadiness(record, orbit), "Rate relative to LVLH, deg/s rms", useless, findings,
                 out);
  }
  if (options.target) {
    const auto& a = *options.axis;
    constexpr double useless = std::numbers::pi / 4.0;
    write_angles(record, off_target(record, a, *options.target, orbit),
                 "Median angle between the axis " + name_of(a) + " of " + record.body + " and " +
                     name_of(*options.target) + ", deg",
                 useless, findings, out);
  }
  return findings.conclude();
}

}  // namespace vectrix::cli

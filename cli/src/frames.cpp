#include "frames.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <ostream>
#include <vector>
#include <vectrix/kinematics/named/graph.hpp>

#include "earth_frame.hpp"
#include "figures.hpp"
#include "plain_words.hpp"
#include "quantile.hpp"
#include "reference_frame.hpp"
#include "resampled.hpp"
#include "sample_faults.hpp"
#include "scenario/flight.hpp"

namespace vectrix::cli {
namespace {

// A frame, and how it hangs on another one.
struct Hanging {
  std::string parent, stated;
  bool has_rate;
};

// The frames of a scenario at one instant: a tree below GCRF, and the graph that answers.
class Frames {
 public:
  Frames(const Scenario& scenario, const FlownAttitude& flown, const Epoch& t) {
    graph_.add_frame("GCRF", FrameMotion::inertial);
    hang("EME2000", {"GCRF", "the bias of J2000", true}, gcrf_from("EME2000"),
         Eigen::Vector3d(0.0, 0.0, 0.0));
    add_reference(scenario, flown.record, t);
    add_attitude(flown.record, t);
    for (const Report::BodyFrame& frame : flown.frames.all()) {
      const auto stated = std::find_if(scenario.frames.begin(), scenario.frames.end(),
                                       [&](const FixedFrame& each) { return each.name == frame.name; });
      if (stated != scenario.frames.end())
        hang(stated->name, {stated->parent, "fixed, " + stated->place.line_text(), true},
             stated->parent_from_frame.toRotationMatrix(), Eigen::Vector3d(0.0, 0.0, 0.0));
    }
    if (scenario.orientation && !hangs("ITRF")) hang_earth(*scenario.orientation, t);
    if (scenario.orbit && !hangs("LVLH")) hang_moving("LVLH", scenario, flown.record, t);
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const Hanging& hanging(const std::string& name) const { return tree_.at(name); }
  [[nodiscard]] bool hangs(const std::string& name) const { return tree_.contains(name); }

  /// The name as it is here. Throws BadInput for another one.
  [[nodiscard]] std::string known(const char* option, const std::string& name) const {
    const std::string found = reference_name(name).value_or(name);
    if (found == "GCRF" || tree_.contains(found)) return found;
    std::vector<std::string_view> all{"GCRF"};
    all.insert(all.end(), names_.begin(), names_.end());
    const std::string missing = found == "ITRF" ? "; it needs orientation = \"FILE\" in [earth]"
                                : !axes_of_reference(found).empty() ? "; it needs [orbit]"
                                                                    : instead_of(found, all);
    throw BadInput(std::string(option) + ": the scenario has no frame '" + name + "'" + missing);
  }

  /// From one frame to another, both included.
  [[nodiscard]] std::vector<std::string> path(const std::string& from, const std::string& to) const {
    std::vector<std::string> up = to_root(from), down = to_root(to);
    std::string meeting = "GCRF";
    while (!up.empty() && !down.empty() && up.back() == down.back()) {
      meeting = up.back();
      up.pop_back();
      down.pop_back();
    }
    up.push_back(meeting);
    up.insert(up.end(), down.rbegin(), down.rend());
    return up;
  }

  [[nodiscard]] Eigen::Matrix3d rotation(const std::string& to, const std::string& from) const {
    return graph_.at(0.0 * si::second).rotation(To(to), From(from)).matrix();
  }
  /// Of `of` relative to the other, along its own axes, rad/s.
  [[nodiscard]] Eigen::Vector3d rate(const std::string& of, const std::string& relative_to) const {
    return graph_.at(0.0 * si::second)
        .angular_velocity(Of(of), RelativeTo(relative_to), In(of))
        .coordinates();
  }

 private:
  void hang(const std::string& name, const Hanging& hanging, const Eigen::Matrix3d& R_parent_from_name,
            const std::optional<Eigen::Vector3d>& w) {
    const NamedFrame parent = graph_.frame(hanging.parent);
    const NamedFrame frame =
        graph_.add_frame(name, name == "EME2000" ? FrameMotion::inertial : FrameMotion::moving);
    const NamedDcm R{detail::trusted, parent, frame, R_parent_from_name};
    if (w) {
      const auto rate =
          angular_velocity(Of(frame), RelativeTo(parent), vector<si::angular_velocity>(In(frame), *w));
      graph_.add_edge(edge(To(parent), From(frame),
                           [moving = moving_dcm(R, rate)](Quantity<si::time>) { return moving; }));
    } else {
      graph_.add_edge(static_edge(R));
    }
    names_.push_back(name);
    tree_.emplace(name, hanging);
  }

  void hang_earth(const EarthOrientation& orientation, const Epoch& t) {
    const auto earth = orientation.at(t);
    hang("ITRF", {"GCRF", "the observed turn of the Earth", true}, earth.rotation.matrix(),
         earth.angular_velocity.coordinates());
  }

  // With a rate only if it is of the Earth.
  void hang_moving(const std::string& name, const Scenario& scenario, const AttitudeRecord& record,
                   const Epoch& t) {
    const TimeSpan time = looked_at(scenario, record);
    const TimeSpan with_t = from_until(std::min(time.start(), t), std::max(time.end(), t));
    const FlownOrbit orbit =
        scenario.orbit ? read_orbit(*scenario.orbit, with_t, middle_of(time)) : FlownOrbit(nullptr);
    const auto motion =
        reference_motion(record.file, name, with_t, orbit, scenario.orientation, reference_keys);
    const std::string axes = axes_of_reference(name);
    hang(name, {"GCRF", axes.empty() ? axes_of_date(name) : "of the orbit, " + axes, false}, motion(t), {});
  }

  // What the attitude is relative to.
  void add_reference(const Scenario& scenario, const AttitudeRecord& record, const Epoch& t) {
    if (inertial(record.reference)) return;
    if (record.reference == "ITRF" && scenario.orientation) {
      hang_earth(*scenario.orientation, t);
    } else {
      hang_moving(record.reference, scenario, record, t);
    }
  }

  void add_attitude(const AttitudeRecord& record, const Epoch& t) {
    const AttitudeStep step = step_at(record, t);
    hang(record.body,
         {record.reference,
          "attitude, between the samples of " + record.times[step.before].utc(3) + " and " +
              record.times[step.before + 1].utc(3) + " UTC of " + record.file,
          true},
         step.at.to_reference.toRotationMatrix(), step.at.rate);
  }

  [[nodiscard]] std::vector<std::string> to_root(std::string name) const {
    std::vector<std::string> all;
    for (; name != "GCRF"; name = tree_.at(name).parent) all.push_back(name);
    return all;
  }

  NamedGraph graph_;
  std::vector<std::string> names_;
  std::map<std::string, Hanging> tree_;
};

void write(const Eigen::Matrix3d& R, std::ostream& out) {
  constexpr int digits = 15;
  for (int i = 0; i < 3; ++i) {
    out << "   ";
    for (int j = 0; j < 3; ++j) out << padded(with_decimals(R(i, j), digits), digits + 4);
    out << '\n';
  }
}

void write_rate(const std::string& of, const std::string& relative_to, const Eigen::Vector3d& w,
                std::ostream& out) {
  constexpr int digits = 6;
  out << "    w of " << of << " relative to " << relative_to << ", in " << of << ", deg/s: (";
  for (int i = 0; i < 3; ++i) out << (i == 0 ? "" : ", ") << with_decimals(degrees * w[i], digits);
  out << "), " << with_decimals(degrees * w.norm(), digits) << '\n';
}

void write_chain(const Frames& frames, const std::string& from, const std::string& to, std::ostream& out) {
  const auto path = frames.path(from, to);
  bool has_rate = true;
  std::string product;
  for (std::size_t k = 1; k < path.size(); ++k) {
    const std::string &inner = path[k - 1], &outer = path[k], factor = "R" + std::to_string(k);
    const bool goes_up = frames.hangs(inner) && frames.hanging(inner).parent == outer;
    const Hanging& edge = frames.hanging(goes_up ? inner : outer);
    product.insert(0, factor + (product.empty() ? "" : " "));
    out << factor << ": v_" << outer << " = " << factor << " v_" << inner << "; " << edge.stated
        << (goes_up ? "" : ", inverted") << '\n';
    write(frames.rotation(outer, inner), out);
    has_rate = has_rate && edge.has_rate;
    if (edge.has_rate) write_rate(inner, outer, frames.rate(inner, outer), out);
    out << '\n';
  }
  const Eigen::Matrix3d R = frames.rotation(to, from);
  const Eigen::Quaterniond q(R);
  out << "R = " << product << ": v_" << to << " = R v_" << from << '\n';
  write(R, out);
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  out << "    as a quaternion, scalar first: (" << detail::text(sign * q.w()) << ", "
      << detail::text(sign * q.x()) << ", " << detail::text(sign * q.y()) << ", "
      << detail::text(sign * q.z()) << ")\n";
  if (has_rate) {
    write_rate(from, to, frames.rate(from, to), out);
  } else {
    out << "    w is not known: a frame of the orbit follows from position and velocity, its rate would need "
           "the acceleration\n";
  }
}

}  // namespace

void frames(const FramesOptions& options, std::ostream& out) {
  if (options.from.empty() != options.to.empty())
    throw BadInput("--from and --to go together: v_to = R v_from");
  const Scenario scenario =
      in_plain_words(options.file.string(), [&] { return read_scenario(options.file); });
  const FlownAttitude flown = read_flown_attitude(scenario);
  const Epoch t = options.at.empty() ? flown.record.times.front() : Epoch::from(options.at);
  require_orientation(scenario, t);
  const Frames all = in_plain_words(options.file.string(), [&] { return Frames(scenario, flown, t); });
  if (options.from.empty()) {
    out << "Frames of " << scenario.file << " at " << t << "\n  GCRF\n";
    for (const std::string& name : all.names())
      out << "  " << name << ", relative to " << all.hanging(name).parent << ": " << all.hanging(name).stated
          << '\n';
    return;
  }
  const std::string from = all.known("--from", options.from), to = all.known("--to", options.to);
  if (from == to) throw BadInput("--from and --to are one frame, " + from);
  out << "From " << from << " to " << to << " at " << t << "\n\n";
  write_chain(all, from, to, out);
}

}  // namespace vectrix::cli

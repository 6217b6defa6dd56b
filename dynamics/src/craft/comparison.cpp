#include <vectrix/dynamics/craft/comparison.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>
#include <vectrix/dynamics/craft/eigen_numbers.hpp>
#include <vectrix/dynamics/craft/joint_counts.hpp>

namespace vectrix::detail {
namespace {

void put_larger(NumberDifference& largest, double size, double t) {
  if (size > largest.size || std::isnan(size)) largest = {size, t};
}

/// The angle of the rotation between two attitudes, also a small one.
double angle_between(const double* ours, const double* theirs) {
  const Eigen::Quaterniond q(ours[0], ours[1], ours[2], ours[3]),
      p(theirs[0], theirs[1], theirs[2], theirs[3]);
  const Eigen::Quaterniond between = q.normalized().conjugate() * p.normalized();
  return 2.0 * std::atan2(between.vec().norm(), std::abs(between.w()));
}

double distance(const double* ours, const double* theirs) {
  return (Eigen::Map<const Eigen::Vector3d>(ours) - Eigen::Map<const Eigen::Vector3d>(theirs)).norm();
}

/// The name of a frame without the namespaces around it, for a table.
std::string short_name(const std::string& name) {
  const std::size_t end = std::min(name.find('<'), name.size()), colons = name.rfind("::", end);
  return colons == std::string::npos ? name : name.substr(colons + 2);
}

/// The numbers of a row that are one quaternion or one vector; else each is a row.
constexpr std::size_t quaternion = 4, vector = 3;

void print_row(std::ostream& out, std::size_t width, const std::string& name, const NumberDifference& found,
               const std::string& unit) {
  std::ostringstream size, time;
  size << std::scientific << std::setprecision(1) << found.size << ' ' << unit;
  time << found.time << " s";
  out << std::left << std::setw(static_cast<int>(width)) << name << "  " << std::setw(22) << size.str()
      << time.str() << '\n';
}

}  // namespace

StateDifferences::StateDifferences(std::shared_ptr<const CraftCore> core, double from, double until)
    : core_(std::move(core)),
      from_(from),
      until_(until),
      our_work_(core_->tree.work()),
      their_work_(core_->tree.work()),
      numbers_(core_->tree.layout().size(), {0.0, from}),
      energy_{0.0, from},
      momentum_{0.0, from},
      angular_momentum_{0.0, from},
      events_({0.0, from}),
      impulses_({0.0, from}) {
  list_rows();
}

void StateDifferences::list_rows() {
  const PlainSpacecraft& craft = core_->plain;
  std::size_t at = 0;
  const auto add = [&](const std::string& name, const std::string& unit, std::size_t count) {
    rows_.push_back({name, unit, at, count});
    at += count;
  };
  add("attitude of " + short_name(craft.hub), "rad", quaternion);
  add("rate of " + short_name(craft.hub), "rad/s", vector);
  if (craft.motion == HubMotion::free) {
    add("position of " + short_name(craft.hub), "m", vector);
    add("velocity of " + short_name(craft.hub), "m/s", vector);
  }
  const auto add_axes = [&](const PlainBody& body, const char* what, const char* unit) {
    const std::size_t axes = counts_of(body.joint).axes;
    for (std::size_t i = 1; i <= axes; ++i)
      add(what + (axes > 1 ? " " + text(i) : std::string()) + " of " + short_name(body.name), unit, 1);
  };
  const auto is_free = [](const PlainBody& body) {
    return body.joint == JointKind::ball || body.joint == JointKind::free;
  };
  for (const PlainBody& body : craft.bodies) {
    add_axes(body, "coordinate", body.joint == JointKind::slider ? "m" : "rad");
    if (is_free(body)) add("attitude of " + short_name(body.name), "rad", quaternion);
    if (body.joint == JointKind::free) add("position of " + short_name(body.name), "m", vector);
  }
  for (const PlainBody& body : craft.bodies) {
    add_axes(body, "speed", body.joint == JointKind::slider ? "m/s" : "rad/s");
    if (is_free(body)) add("rate of " + short_name(body.name), "rad/s", vector);
    if (body.joint == JointKind::free) add("velocity of " + short_name(body.name), "m/s", vector);
  }
  for (const PlainRotor& rotor : craft.rotors) add("spin of " + short_name(rotor.name), "rad/s", 1);
  for (const PlainMode& mode : craft.modes) add("deflection of " + short_name(mode.name), "kg^1/2 m", 1);
  for (const PlainMode& mode : craft.modes) add("rate of " + short_name(mode.name), "kg^1/2 m/s", 1);
}

void StateDifferences::add(double t, const double* ours, const double* theirs) {
  for (const Row& row : rows_) {
    const double *a = ours + row.at, *b = theirs + row.at;
    const double size = row.count == quaternion ? angle_between(a, b)
                        : row.count == vector   ? distance(a, b)
                                                : std::abs(*a - *b);
    put_larger(numbers_[row.at], size, t);
  }
  const auto conserved = [&](const double* y, multibody::Work<double>& work) {
    core_->tree.place(y, work);
    return core_->tree.conserved(y, multibody::zero_column<double>(), work);
  };
  const auto a = conserved(ours, our_work_), b = conserved(theirs, their_work_);
  put_larger(energy_, std::abs(a.energy - b.energy), t);
  put_larger(momentum_, (eigen(a.momentum) - eigen(b.momentum)).norm(), t);
  put_larger(angular_momentum_, (eigen(a.angular_momentum) - eigen(b.angular_momentum)).norm(), t);
}

// All events come first: two runs that end at one event do so at two times.
void StateDifferences::set_events(std::vector<EventTime> ours, std::vector<EventTime> theirs) {
  const auto same = [&] {
    return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                      [](const EventTime& a, const EventTime& b) { return a.name == b.name; });
  };
  if (!same())
    for (auto* events : {&ours, &theirs})
      std::erase_if(*events, [&](const EventTime& e) { return e.time < from_ || e.time > until_; });
  our_events_ = ours.size();
  their_events_ = theirs.size();
  if (!same()) {
    events_.reset();
    return;
  }
  for (std::size_t i = 0; i < ours.size(); ++i)
    put_larger(*events_, std::abs(ours[i].time - theirs[i].time), ours[i].time);
}

void StateDifferences::set_impulses(const std::vector<double>& ours, const std::vector<double>& theirs) {
  our_impulses_ = ours.size();
  their_impulses_ = theirs.size();
  if (our_impulses_ != their_impulses_) {
    impulses_.reset();
    return;
  }
  for (std::size_t i = 0; i < ours.size(); ++i) {
    put_larger(*impulses_, std::abs(ours[i] - theirs[i]), ours[i]);
    between_impulses_.push_back({std::min(ours[i], theirs[i]), std::max(ours[i], theirs[i])});
  }
}

bool StateDifferences::is_between_impulses(double t) const {
  const auto found = std::partition_point(between_impulses_.begin(), between_impulses_.end(),
                                          [t](const auto& both) { return both[1] < t; });
  return found != between_impulses_.end() && (*found)[0] <= t;
}

void StateDifferences::print(std::ostream& out) const {
  std::ostringstream table;  // whose format is not that of `out`
  std::size_t width = std::string("angular momentum").size();
  for (const Row& row : rows_) width = std::max(width, row.name.size());
  table << std::left << std::setw(static_cast<int>(width)) << text(from_) + " to " + text(until_) + " s"
        << "  " << std::setw(22) << "largest difference"
        << "at\n";
  for (const Row& row : rows_) print_row(table, width, row.name, numbers_[row.at], row.unit);
  print_row(table, width, "energy", energy_, "J");
  if (core_->plain.motion == HubMotion::free) print_row(table, width, "momentum", momentum_, "kg m/s");
  print_row(table, width, "angular momentum", angular_momentum_, "N m s");
  if (!events_)
    table << "the events differ: " << our_events_ << " and " << their_events_ << ", or their names\n";
  else if (our_events_ > 0)
    print_row(table, width, "times of events", *events_, "s");
  if (!impulses_)
    table << "the impulses differ: " << our_impulses_ << " and " << their_impulses_ << '\n';
  else if (our_impulses_ > 0)
    print_row(table, width, "times of impulses", *impulses_, "s");
  out << table.str();
}

}  // namespace vectrix::detail

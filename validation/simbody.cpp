#include <vectrix/dynamics.hpp>

#include "comparison.hpp"
#include "nasa_runs.hpp"
#include "simbody_scenario.hpp"

namespace vectrix::validation {
namespace {

// Simbody bounds the error of one step, relative to the size of the motion. Over a run the errors of the
// steps add up, so the tolerance at the end is accuracy * steps * size. To show that the difference is
// Simbody's, only Simbody's accuracy is tightened: a hundred times tighter must reduce the difference at
// least ten times.
constexpr double accuracies[] = {1e-6, 1e-8, 1e-10, 1e-12};
constexpr double largest_ratio = 0.1;

constexpr double interval_s = 600.0;

std::string power(double accuracy) {
  return "1e" + std::to_string(static_cast<int>(std::round(std::log10(accuracy))));
}

struct Compared {
  Difference difference;
  double steps;
};

SimbodyBody simbody_body(const NasaRun& run) {
  SimbodyBody body = simbody_body(run.craft, run.start, run.mu);
  body.gravity_gradient = run.gravity_gradient;
  if (run.pulse)
    body.pulses.push_back(
        {run.pulse->start.value(), run.pulse->end.value(), detail::array(run.pulse->torque_b.coordinates())});
  return body;
}

using Motion = std::function<CraftState<Satellite>(const Quantity<si::time>&)>;
Compared compare(const NasaRun& run, const Motion& ours, double accuracy, const std::vector<double>& times) {
  const SimbodyRun theirs =
      simbody_propagate(simbody_body(run), accuracy, times, SimbodyIntegrator::runge_kutta_merson);
  Difference difference;
  for (const SimbodySample& sample : theirs.samples) {
    const MovingTransform<Inertial, Body> now = ours(sample.t_s * si::second).hub_motion();
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    difference.attitude(now.turning.rotation, Eigen::Map<const RowMajor>(sample.R_i_from_b.data()));
    difference.rate(now.turning.angular_velocity, Eigen::Map<const Eigen::Vector3d>(sample.w_ib_b.data()));
    difference.position(now.translation, Eigen::Map<const Eigen::Vector3d>(sample.r_i_m.data()));
  }
  return {difference, static_cast<double>(theirs.steps)};
}

// Adds the comparison at the tightest accuracy to `rows`, and the effect of tightening to `tightened`.
void report(Rows& rows, Rows& tightened, const std::string& what, const std::string& name_of_run,
            double Difference::*watched, const std::string& watched_name) {
  const NasaRun run = nasa_run(name_of_run);
  const Motion ours = fly(run, nasa_duration_s);
  std::vector<double> times;
  for (double t = 0.0; t <= nasa_duration_s; t += interval_s) times.push_back(t);

  std::vector<Compared> runs;
  for (const double accuracy : accuracies) runs.push_back(compare(run, ours, accuracy, times));

  const std::string name = what + " (NASA run " + name_of_run + "), every 600 s to 28800 s";
  const double of_run = std::end(accuracies)[-1] * runs.back().steps;
  const double radius = run.start.hub_motion().translation.coordinates().norm();
  const double orbital_rate = run.start.hub_motion().velocity.coordinates().norm() / radius;
  const Difference& last = runs.back().difference;
  const std::string reason = "Simbody's accuracy " + power(std::end(accuracies)[-1]) + " times its steps";
  rows.push_back({"Simbody", name, "attitude", of_run, "rad", reason, last.attitude_rad});
  rows.push_back({"Simbody", name, "body rate", of_run * orbital_rate, "rad/s",
                  reason + " and the orbital rate", last.rate_rad_s});
  rows.push_back(
      {"Simbody", name, "position", of_run * radius, "m", reason + " and the radius", last.position_m});
  for (std::size_t i = 1; i < runs.size(); ++i) {
    tightened.push_back(
        {"Simbody with tighter accuracy: the difference is Simbody's", name,
         watched_name + ", accuracy " + power(accuracies[i]) + " over " + power(accuracies[i - 1]),
         largest_ratio, "", "Simbody's accuracy is a hundred times tighter",
         runs[i].difference.*watched / runs[i - 1].difference.*watched});
  }
}

}  // namespace

Rows simbody_rows(const std::string&) {
  Rows rows;
  Rows tightened;
  report(rows, tightened, "torque-free", "2", &Difference::position_m, "position");
  report(rows, tightened, "pulse torque", "9A", &Difference::position_m, "position");
  report(rows, tightened, "gravity gradient", "10A", &Difference::attitude_rad, "attitude");
  rows.insert(rows.end(), tightened.begin(), tightened.end());
  return rows;
}

}  // namespace vectrix::validation

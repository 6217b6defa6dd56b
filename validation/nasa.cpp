#include <vectrix/dynamics.hpp>
#include <vectrix/space/files/csv_table.hpp>

#include "comparison.hpp"
#include "nasa_runs.hpp"

namespace vectrix::validation {
namespace {

// NASA's figures have 16 digits. The rounding of the inputs and of 28 800 s of integration is a hundred times
// smaller than these tolerances.
constexpr double attitude_tolerance_rad = 1e-10;
constexpr double rate_tolerance_rad_s = 1e-14;
constexpr double position_tolerance_m = 1e-3;
constexpr const char* nasa_reason = "16 printed digits; rounding over 8 h";

CsvTable read(const std::string& file) {
  return CsvTable::read(file, {"run", "t_s", "x_m", "y_m", "z_m", "wx_radps", "wy_radps", "wz_radps", "T11",
                               "T12", "T13", "T21", "T22", "T23", "T31", "T32", "T33"});
}

void add(Difference& difference, const CraftState<Satellite>& state, const CsvTable& table, std::size_t row) {
  const auto number = [&](const char* name) { return table.number(row, name); };
  Eigen::Matrix3d T;  // body from inertial
  T << number("T11"), number("T12"), number("T13"), number("T21"), number("T22"), number("T23"),
      number("T31"), number("T32"), number("T33");
  const MovingTransform<Inertial, Body> now = state.hub_motion();
  difference.attitude(now.turning.rotation, T.transpose());
  difference.rate(now.turning.angular_velocity, {number("wx_radps"), number("wy_radps"), number("wz_radps")});
  difference.position(now.translation, {number("x_m"), number("y_m"), number("z_m")});
}

void report(Rows& rows, const std::string& scenario, const Difference& difference) {
  rows.push_back(
      {"NASA", scenario, "attitude", attitude_tolerance_rad, "rad", nasa_reason, difference.attitude_rad});
  rows.push_back(
      {"NASA", scenario, "body rate", rate_tolerance_rad_s, "rad/s", nasa_reason, difference.rate_rad_s});
  rows.push_back(
      {"NASA", scenario, "position", position_tolerance_m, "m", nasa_reason, difference.position_m});
}

}  // namespace

Rows nasa_rows(const std::string& data) {
  Rows rows;
  const CsvTable finals = read(data + "/nasa_final_states.csv");
  for (std::size_t row = 0; row < finals.rows(); ++row) {
    const std::string run = finals.text(row, "run").substr(4);  // "RUN_10A" -> "10A"
    const double end = finals.number(row, "t_s");
    Difference difference;
    add(difference, fly(nasa_run(run), end)(end * si::second), finals, row);
    report(rows, "run " + run + " at " + std::to_string(static_cast<int>(end)) + " s", difference);
  }
  const CsvTable minutes = read(data + "/nasa_10A_first_300s.csv");
  const auto motion = fly(nasa_run("10A"), 300.0);
  Difference difference;
  for (std::size_t row = 0; row < minutes.rows(); ++row) {
    add(difference, motion(minutes.number(row, "t_s") * si::second), minutes, row);
  }
  report(rows, "run 10A, each minute to 300 s", difference);
  return rows;
}

}  // namespace vectrix::validation

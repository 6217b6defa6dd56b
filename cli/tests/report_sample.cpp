// report_sample cubesat|long|hostile <file>: writes a report for the browser to try. `cubesat` is two hours
// of CTIM, from its telemetry, as examples/radiometer_on_sun.cpp has them; `long` has a million samples;
// `hostile` has names that end the script.
#include "report/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "figures.hpp"
#include "new_file.hpp"
#include "quantile.hpp"

namespace {

using namespace vectrix;
using cli::Report;
using earth::Gcrf, earth::Itrf, earth::Teme;

struct Satellite : moving_frame {};
struct Lvlh : moving_frame {};
struct Body : moving_frame {};
struct Radiometer : moving_frame {};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::filesystem::path data = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data";
const auto attitude_file = data / "CTIM_20230420_attitude.csv",
           pointing_file = data / "CTIM_20230420_pointing.csv", elements_file = data / "CTIM_20230419.tle",
           earth_file = data / "finals2000A_april_2023.txt";

std::vector<AttitudeSample<Body, Gcrf, Epoch>> read_attitude() {
  const auto table =
      CsvTable::read(attitude_file, {"UTC", "quaternion_c", "quaternion_x", "quaternion_y", "quaternion_z"});
  std::vector<AttitudeSample<Body, Gcrf, Epoch>> samples;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto q = [&](const char* column) { return 5e-10 * table.number(i, column); };  // of norm 2e9
    samples.push_back(
        {table.value(i, "UTC", Epoch::from_utc),
         nearest_quaternion_scalar_first(to<Body>, from<Gcrf>, q("quaternion_c"), q("quaternion_x"),
                                         q("quaternion_y"), q("quaternion_z"))
             .quaternion});
  }
  return samples;
}

struct Published {
  Epoch time;
  double off_sun;  // deg
};
std::vector<Published> read_pointing() {
  const auto table = CsvTable::read(pointing_file, {"microsecondssincegpsepoch", "timdotsun"});
  std::vector<Published> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto microseconds = static_cast<std::int64_t>(table.number(i, "microsecondssincegpsepoch"));
    rows.push_back({Epoch::from_gps_seconds(microseconds / 1'000'000,
                                            1e-6 * static_cast<double>(microseconds % 1'000'000)),
                    cli::degrees * std::acos(table.number(i, "timdotsun"))});
  }
  return rows;
}

Report::Input input(const std::filesystem::path& file) {
  const std::string command = "sha256sum '" + file.string() + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::array<char, 65> digits{};
  if (!pipe || std::fread(digits.data(), 1, 64, pipe.get()) != 64)
    throw std::runtime_error(command + " failed");
  return {std::filesystem::relative(file, VECTRIX_SOURCE_DIR).string(), std::filesystem::file_size(file),
          digits.data()};
}

template <class Named, class Value>
void add(std::vector<Named>& curves, std::size_t place, const char* name, const Value& value) {
  if (curves.size() <= place) curves.push_back({name, {}});
  if constexpr (requires { curves[place].values; }) {
    curves[place].values.push_back(value);
  } else {
    curves[place].vectors.push_back(value);
  }
}

Eigen::Quaterniond plain_quaternion(const auto& rotation) {
  return Eigen::Quaterniond(rotation.matrix());
}

// What is required of the samples while the Sun is to be looked at.
void add_verdicts(Report& report, const std::vector<double>& off_sun, const std::vector<double>& seconds) {
  const double from = (Epoch::from_utc("2023-04-20T05:20:00") - report.start).value();
  const double until = (Epoch::from_utc("2023-04-20T06:10:00") - report.start).value();
  std::vector<double> within;
  for (std::size_t i = 0; i < seconds.size(); ++i)
    if (seconds[i] >= from && seconds[i] <= until) within.push_back(off_sun[i]);
  std::sort(within.begin(), within.end());
  report.tables.push_back(
      {"Angle between boresight and Sun, 05:20 to 06:10 UTC, " + cli::counted(within.size(), "sample"),
       {"percent of the samples", "at most, deg"},
       {}});
  for (const double percent : {50.0, 90.0, 95.0, 99.7, 100.0})
    report.tables.back().rows.push_back(
        {cli::shown(percent), cli::decimals(within[cli::place_of_quantile(percent, within.size())])});
  const auto require = [&](double percent, double required) {
    const double reached = within[cli::place_of_quantile(percent, within.size())];
    report.verdicts.push_back(
        {"angle between the boresight (-z of Radiometer) and the Sun, geometric, 05:20 to 06:10",
         "at most " + cli::shown(required) + " deg in " + cli::shown(percent) + " % of the samples",
         cli::decimals(reached) + " deg", cli::decimals(required - reached) + " deg", reached <= required});
  };
  require(95.0, 0.5);
  require(99.7, 0.1);
}

Report cubesat() {
  const auto orientation = EarthOrientation::read(earth_file);
  const auto elements = TwoLineElements::read(elements_file).front();
  const Sgp4<Satellite> orbit(elements, at_most(1.0 * si::day));
  const auto R_body_from_radiometer =
      dcm(nearest_quaternion_scalar_first(to<Body>, from<Radiometer>, 9.999876e-01, 1.534418e-03,
                                          4.728365e-03, -7.255375e-06)
              .quaternion);
  const auto attitude = read_attitude();
  const SampledAttitude body(attitude, 30.0 * si::second);
  const auto graph = frame_graph(edge(orientation), edge(teme(orientation)), edge(orbit), edge(body),
                                 rigid_edge(R_body_from_radiometer),
                                 edge([](const Displacement<Gcrf, Satellite, In<Gcrf>>& r,
                                         const Velocity<Gcrf, Satellite, ObservedFrom<Gcrf>, In<Gcrf>>& v) {
                                   return lvlh(from<Lvlh>, r, v);
                                 }));
  const auto published = read_pointing();
  const Ephemeris<sky::Sun> sun(from_until(published.front().time, published.back().time));
  const auto boresight = -unit_z(in<Radiometer>);

  Report report{.title = "CTIM: did the radiometer look at the Sun?",
                .start = published.front().time,
                .facts = {{"Body", "CTIM, a 6U cubesat, catalogue number 52950"},
                          {"Attitude", "telemetry each 10 s, turned at a constant rate in between"},
                          {"Orbit", "SGP4 from two-line elements of " + elements.epoch().utc(0) + " UTC"},
                          {"Compared with", "cosines that the flight's own ground processing has published"}},
                .version = VECTRIX_VERSION};
  Report::Scene scene{.body = "Body", .reference = "GCRF", .seconds = {}, .reference_from_body = {}};
  scene.frames = {{"Radiometer", plain_quaternion(R_body_from_radiometer)}};
  scene.axes = {{"boresight", (R_body_from_radiometer * boresight).coordinates()}};
  scene.views = {{"LVLH", {}}, {"ITRF", {}}};
  Report::Plot angle{
      .title = "Angle between boresight and Sun", .unit = "deg", .axes = "", .seconds = {}, .curves = {}};
  angle.limits = {{0.5, "0.5 deg for 95 %"}, {0.1, "0.1 deg for 99.7 %"}};
  Report::Plot difference{
      .title = "The same less what was published", .unit = "arcsec", .axes = "", .seconds = {}, .curves = {}};
  Report::Plot rate{
      .title = "Rate of Body relative to GCRF", .unit = "deg/s", .axes = "Body", .seconds = {}, .curves = {}};
  Report::Plot height{.title = "Height above WGS-84", .unit = "km", .axes = "", .seconds = {}, .curves = {}};
  for (const auto& [t, off_sun] : published) {
    const auto now = graph.at(t);
    scene.seconds.push_back((t - report.start).value());
    const auto R_gcrf_from_body = now.rotation(to<Gcrf>, from<Body>);
    const auto to_sun = sun.direction(now, seen_from<Satellite>, geometric, in<Radiometer>);
    const auto r = now.position(of<Satellite>, relative_to<Gcrf>, in<Gcrf>);
    const auto v = now.velocity(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
    const auto place = wgs84::geodetic(now.position(of<Satellite>, relative_to<Itrf>, in<Itrf>).vector());
    const double ours = angle_between(boresight, to_sun).in(si::degree);
    add(angle.curves, 0, "from the telemetry", ours);
    add(angle.curves, 1, "published", off_sun);
    add(difference.curves, 0, "difference", 3600.0 * (ours - off_sun));
    const Eigen::Vector3d w =
        cli::degrees * now.angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>).coordinates();
    add(rate.curves, 0, "x", w.x());
    add(rate.curves, 1, "y", w.y());
    add(rate.curves, 2, "z", w.z());
    add(height.curves, 0, "height", place.height.in(si::kilometre));
    scene.reference_from_body.push_back(plain_quaternion(R_gcrf_from_body));
    add(scene.directions, 0, "Sun", (now.rotation(to<Gcrf>, from<Radiometer>) * to_sun).coordinates());
    add(scene.directions, 1, "Earth", Eigen::Vector3d(-r.coordinates().normalized()));
    add(scene.directions, 2, "velocity", Eigen::Vector3d(v.coordinates().normalized()));
    scene.views[0].from_reference.push_back(plain_quaternion(now.rotation(to<Lvlh>, from<Gcrf>)));
    scene.views[1].from_reference.push_back(plain_quaternion(now.rotation(to<Itrf>, from<Gcrf>)));
    scene.positions.push_back(r.coordinates());
    scene.ground_track.emplace_back(place.latitude.angle.in(si::degree), place.longitude.in(si::degree));
  }
  for (Report::Plot* plot : {&angle, &difference, &rate, &height}) plot->seconds = scene.seconds;
  add_verdicts(report, angle.curves.front().values, scene.seconds);
  report.plots = {angle, difference, rate, height};
  report.scene = scene;
  for (const auto& file : {attitude_file, pointing_file, elements_file, earth_file})
    report.inputs.push_back(input(file));
  report.choices = {
      {"quaternion", "scalar first; R(q) takes coordinates from GCRF to Body", "examples/data/README.md"},
      {"mounting", "R(q) takes coordinates from Radiometer to Body", "examples/radiometer_on_sun.cpp"},
      {"Sun", "geometric, seen from the satellite", "examples/radiometer_on_sun.cpp"}};
  return report;
}

// A million samples, ten a second. A single one stands out, and a minute is missing.
Report long_run() {
  constexpr std::size_t count = 1'000'000, spike = 654'321, gap = 300'000, gap_end = gap + 600;
  Report report{.title = "A million samples",
                .start = Epoch::from_utc("2026-11-29T00:00:00"),
                .version = VECTRIX_VERSION};
  Report::Plot rate{.title = "Rate",
                    .unit = "deg/s",
                    .axes = "Body",
                    .seconds = {},
                    .curves = {{"x", {}}, {"y", {}}, {"z", {}}}};
  Report::Scene scene{.body = "Body", .reference = "GCRF", .seconds = {}, .reference_from_body = {}};
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    scene.seconds.push_back(t);
    for (std::size_t k = 0; k < 3; ++k) {
      double value = std::sin(1e-3 * t + static_cast<double>(k)) + 0.1 * std::sin(7.0 * t);
      if (k == 0 && i == spike) value = 5.0;
      if (i >= gap && i < gap_end) value = nan;
      rate.curves[k].values.push_back(value);
    }
    scene.reference_from_body.emplace_back(Eigen::AngleAxisd(1e-3 * t, Eigen::Vector3d(0.6, 0.0, 0.8)));
    if (i == gap) scene.reference_from_body.back().coeffs().setConstant(nan);
  }
  rate.seconds = scene.seconds;
  report.plots = {rate};
  report.scene = std::move(scene);
  return report;
}

Report hostile() {
  const std::string name = "</script><script>document.title = 'taken'</script><!-- & \"";
  Report report{.title = name, .start = Epoch::from_utc("2026-11-29T00:00:00"), .version = VECTRIX_VERSION};
  report.verdicts = {{name, name, name, name, false}};
  report.plots = {{name, name, name, {-1.0, 0.0, 1.0}, {{name, {nan, 1.0, nan}}}, {{0.0, name}}}};
  report.scene =
      Report::Scene{.body = name, .reference = name, .seconds = {0.0, 1.0}, .reference_from_body = {}};
  report.scene->reference_from_body.assign(2, Eigen::Quaterniond::Identity());
  return report;
}

}  // namespace

int main(int count, char** words) try {
  const std::map<std::string, Report (*)(), std::less<>> all{
      {"cubesat", cubesat}, {"long", long_run}, {"hostile", hostile}};
  const auto wanted = all.find(count == 3 ? words[1] : "");
  if (wanted == all.end()) {
    std::cerr << "usage: report_sample cubesat|long|hostile <file>\n";
    return 2;
  }
  cli::write_new(words[2], cli::html(wanted->second()), true);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "report_sample: " << error.what() << '\n';
  return 1;
}

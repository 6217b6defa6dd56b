// Where did Sentinel-1A look? Twenty-five seconds of a real radar pass, from the files of the image.
//
// Seven frames in one graph:
//
//     Satellite --- Itrf --- Gcrf --- QuaternionAxes --- Body --- Antenna
//                              \--- Orbit
//
//     r^itrf, v^itrf    the orbit, in axes of the Earth
//     R_itrf^gcrf, w    Earth orientation, observed by the IERS
//     R_orbit^gcrf      z to nadir, y along -(r x v) with inertial v, x = y x z; follows from the other edges
//     R_axes^gcrf, w    the quaternions; between two of them the turn at constant rate
//     R_axes^body       [0 -1 0; -1 0 0; 0 0 -1]
//     R_body^antenna    the boresight, x of the antenna, is z of the body
//
// Every question is a path through the graph. The graph multiplies the matrices and adds the rates:
//
//     R_itrf^body  = R_axes^body R_gcrf^axes R_itrf^gcrf           the inner frames cancel
//     w_gb^b       = R_axes^body w_ga^a                            g Gcrf, b Body, rigid on the axes a
//     v^gcrf       = R_itrf^gcrf (v^itrf + w_gi^i x r^itrf)        i Itrf
//     R_orbit^body = R1(roll) R2(pitch) R3(yaw), passive           by yaw, then pitch, then roll
//     r^itrf + s R_antenna^itrf e_x, s > 0                         meets the ellipsoid WGS-84
//
// The producer documents neither the axes of the quaternions nor their inertial frame. R_axes^body was found
// by trying all permutations of axes. The inertial frame is the mean equator and equinox of J2000, which is
// Gcrf to 0.023 arcsec (6e-6 deg).
//
// Expected results: x is along the velocity relative to the Earth to about 1 mdeg. This is zero-Doppler
// steering; it causes the yaw relative to an orbit frame that uses the inertial velocity. The radar looks
// 30 deg to the right. The rate from the quaternions agrees with that of the gyros, an independent
// instrument, to 2 urad/s.
//
//     sentinel1_pass [data directory] [table to write, .csv]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <vectrix/space.hpp>

#ifndef VECTRIX_EXAMPLE_DATA
#define VECTRIX_EXAMPLE_DATA "examples/data"
#endif

namespace {

using namespace vectrix;
using earth::Gcrf, earth::Itrf;

struct Satellite : moving_frame {};  // moves with the satellite, axes parallel to Itrf
struct Orbit : moving_frame {};
struct QuaternionAxes : moving_frame {};
struct Body : moving_frame {};
struct Antenna : moving_frame {};

constexpr double printed_to = 1e-6;  // the quaternions have seven decimals

struct Telemetry {
  std::vector<AttitudeSample<Gcrf, QuaternionAxes, Epoch>> attitude;
  std::vector<Vector<Body, si::angular_velocity>> gyro_body;  // at the same epochs
  double off_unit = 0.0;  // largest deviation from 1 of the printed quaternions' norms
};

// Results of the graph at one instant; angles in degrees.
struct Look {
  Epoch epoch;
  double off_velocity, roll, pitch, yaw;
  Vector<Body, si::angular_velocity> rate_body, gyro_body;  // relative to Gcrf
  double latitude, longitude, incidence;                    // where the antenna's axis meets the ground
};

template <class Sample>
Epoch next_epoch(const std::vector<Sample>& samples, const CsvTable& table, std::size_t row) {
  const char* const column = "time_utc";
  const auto epoch = table.value(row, column, Epoch::from_utc);
  if (!samples.empty() && !(samples.back().time < epoch)) {
    table.refuse(
        row, column,
        table.text(row, column) + " is not after " + samples.back().time.utc() + " of the row before");
  }
  return epoch;
}

std::vector<PositionSample<Itrf, Satellite, Epoch>> read_orbit(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"time_utc", "x_m", "y_m", "z_m", "vx_mps", "vy_mps", "vz_mps"});
  std::vector<PositionSample<Itrf, Satellite, Epoch>> samples;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto r = read_vector<si::length>(in<Itrf>, table, i, {"x_m", "y_m", "z_m"});
    const auto v = read_vector<si::velocity>(in<Itrf>, table, i, {"vx_mps", "vy_mps", "vz_mps"});
    samples.push_back({next_epoch(samples, table, i),
                       point_motion(of<Satellite>, relative_to<Itrf>, observed_from<Itrf>, r, v)});
  }
  return samples;
}

Telemetry read_attitude(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"time_utc", "q0", "q1", "q2", "q3", "wx", "wy", "wz"});
  Telemetry telemetry;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto q = [&](const char* column) { return table.number(i, column); };
    const auto nearest = table.value(i, "q0", [&](const std::string&) {
      return nearest_quaternion_scalar_last(to<Gcrf>, from<QuaternionAxes>, q("q0"), q("q1"), q("q2"),
                                            q("q3"));
    });
    if (nearest.distance > printed_to)
      table.refuse(i, "q0", "the norm of q0 to q3 is off 1 by " + std::to_string(nearest.distance));
    telemetry.attitude.push_back({next_epoch(telemetry.attitude, table, i), nearest.quaternion});
    telemetry.gyro_body.push_back(read_vector<si::angular_velocity>(in<Body>, table, i, {"wx", "wy", "wz"}));
    telemetry.off_unit = std::max(telemetry.off_unit, nearest.distance);
  }
  return telemetry;
}

// All questions to the graph at one epoch.
template <class Graph>
Look look(const Graph& graph, const Epoch& epoch, const Vector<Body, si::angular_velocity>& gyro_body) {
  const auto now = graph.at(epoch);

  const auto v_body = now.velocity(of<Satellite>, relative_to<Itrf>, observed_from<Itrf>, in<Body>);
  const auto attitude = euler_angles(intrinsic<3, 2, 1>, now.rotation(to<Orbit>, from<Body>));
  const auto w_gb_body = now.angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>);

  const auto axis_itrf = now.rotation(to<Itrf>, from<Antenna>) * unit_x(in<Antenna>);
  const auto r_itrf = now.position(of<Satellite>, relative_to<Itrf>, in<Itrf>);
  const auto ground = wgs84::first_intersection(r_itrf, axis_itrf);
  if (!ground) throw BadInput("the antenna's axis misses the Earth at " + epoch.utc());
  const Geodetic place = wgs84::geodetic(*ground);

  return {epoch,
          angle_between(unit_x(in<Body>), v_body).in(si::degree),
          attitude.third().in(si::degree),
          attitude.second().in(si::degree),
          attitude.first().in(si::degree),
          w_gb_body.vector(),
          gyro_body,
          place.latitude.angle.in(si::degree),
          place.longitude.in(si::degree),
          angle_between(wgs84::up(*ground), -axis_itrf).in(si::degree)};
}

double micro(const Quantity<si::angular_velocity>& rate) {
  return 1e6 * rate.value();
}

constexpr const char* heading =
    R"(off v: body x from the velocity relative to the Earth. Roll, pitch, yaw: body from orbit, R1(roll) R2(pitch) R3(yaw);
the orbit frame has z to the Earth's centre, y along -(r x v), v inertial. wx, wy, wz: rate of the body relative to Gcrf
in body axes, from the graph; gyro: |w - w of the gyros|. Latitude, geodetic, and longitude: where the antenna's axis
meets WGS-84, north and east.

)";

void print(const std::vector<Look>& looks) {
  std::printf("%s", heading);
  constexpr const char* columns = "%-12s  %6s  %8s %7s %7s  %7s  %7s  %7s  %6s  %8s %9s\n";
  std::printf(columns, "UTC", "off v", "roll", "pitch", "yaw", "wx", "wy", "wz", "gyro", "latitude",
              "longitude");
  std::printf(columns, "", "mdeg", "deg", "deg", "deg", "urad/s", "urad/s", "urad/s", "urad/s", "deg", "deg");
  for (const Look& look : looks) {
    std::printf("%s  %6.2f  %8.4f %7.4f %7.4f  %7.2f  %7.2f  %7.2f  %6.2f  %8.4f %9.4f\n",
                look.epoch.utc(3).substr(11).c_str(), 1e3 * look.off_velocity, look.roll, look.pitch,
                look.yaw, micro(look.rate_body.x()), micro(look.rate_body.y()), micro(look.rate_body.z()),
                micro(norm(look.rate_body - look.gyro_body)), look.latitude, look.longitude);
  }
}

void summarise(const std::vector<Look>& looks, double off_unit) {
  const auto line = [&](const char* text, int decimals, const char* unit, const char* expected, auto figure) {
    std::vector<double> figures;
    for (const Look& look : looks) figures.push_back(figure(look));
    const auto [low, high] = std::minmax_element(figures.begin(), figures.end());
    std::printf("%-47s %6.*f to %6.*f %-7s %s\n", text, decimals, *low, decimals, *high, unit, expected);
  };
  std::printf("\n%-71s expected\n", "");
  line("Body x from the velocity relative to the Earth", 2, "mdeg", "about 1: steered to zero Doppler",
       [](const Look& l) { return 1e3 * l.off_velocity; });
  line("Roll from nadir", 2, "deg", "about -30: the radar looks to the right",
       [](const Look& l) { return l.roll; });
  line("Incidence of the antenna's axis on WGS-84", 2, "deg", "33.7: such a roll, 700 km above the Earth",
       [](const Look& l) { return l.incidence; });
  line("Rate of the quaternions less that of the gyros", 2, "urad/s", "about 2: the noise of the gyros",
       [](const Look& l) { return micro(norm(l.rate_body - l.gyro_body)); });
  std::printf("%-47s %16.3f ppm     below 0.1: seven decimals are printed\n",
              "Norm of the quaternions, off 1 by at most", 1e6 * off_unit);
}

void write(const std::vector<Look>& looks, const std::filesystem::path& file) {
  std::ofstream out(file);
  out.precision(12);
  out << "time_utc,x_off_velocity_deg,roll_deg,pitch_deg,yaw_deg,wx_rad_s,wy_rad_s,wz_rad_s,"
         "gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s,latitude_deg,longitude_deg,incidence_deg\n";
  for (const Look& look : looks) {
    out << look.epoch.utc() << ',' << look.off_velocity << ',' << look.roll << ',' << look.pitch << ','
        << look.yaw;
    for (const auto& rate : {look.rate_body, look.gyro_body}) {
      for (const double w : rate.coordinates()) out << ',' << w;
    }
    out << ',' << look.latitude << ',' << look.longitude << ',' << look.incidence << '\n';
  }
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
  std::printf("\n%zu rows written to %s\n", looks.size(), file.c_str());
}

void run(const std::filesystem::path& data, const std::filesystem::path& table) {
  const auto orientation = EarthOrientation::read(data / "finals2000A_april_2022.txt");
  const auto orbit = read_orbit(data / "S1A_IW_20220414T102211_orbit.csv");
  const auto telemetry = read_attitude(data / "S1A_IW_20220414T102211_attitude.csv");

  const EarthMotion earth(orientation,
                          from_until(telemetry.attitude.front().time, telemetry.attitude.back().time));
  // Cubic interpolation between orbit samples ten seconds apart has an error of 0.3 mm.
  const auto satellite = sampled_edge(orbit, 20.0 * si::second);
  const auto attitude = sampled_edge(telemetry.attitude, 2.0 * si::second);
  const auto orbit_frame = edge([](const Displacement<Itrf, Satellite, In<Gcrf>>& r,
                                   const Velocity<Itrf, Satellite, ObservedFrom<Gcrf>, In<Gcrf>>& v) {
    return lvlh(from<Orbit>, r, v);
  });
  const auto R_body_from_axes = dcm_from_axes(to<Body>, -unit_y(in<QuaternionAxes>),
                                              -unit_x(in<QuaternionAxes>), -unit_z(in<QuaternionAxes>));
  const auto R_antenna_from_body = turned_y(to<Antenna>, from<Body>, convert<si::angle>(-90.0 * si::degree));
  const auto graph = frame_graph(edge(earth), satellite, orbit_frame, attitude, rigid_edge(R_body_from_axes),
                                 rigid_edge(R_antenna_from_body));

  std::vector<Look> looks;
  for (std::size_t i = 0; i + 1 < telemetry.attitude.size(); ++i) {
    const Epoch &a = telemetry.attitude[i].time, &b = telemetry.attitude[i + 1].time;
    looks.push_back(
        look(graph, a + 0.5 * (b - a), 0.5 * (telemetry.gyro_body[i] + telemetry.gyro_body[i + 1])));
  }
  std::printf("Sentinel-1A, %s, %zu s. Contains Copernicus Sentinel data [2022].\n",
              looks.front().epoch.utc(0).substr(0, 10).c_str(), looks.size());
  print(looks);
  summarise(looks, telemetry.off_unit);
  if (table.empty()) {
    std::printf(
        "\nAll figures as a table: sentinel1_pass <data directory> <table.csv>, or ./dev demo <table.csv>\n");
  } else {
    write(looks, table);
  }
}

}  // namespace

int main(int count, char** words) {
  if (count > 3 || (count > 1 && words[count - 1][0] == '-')) {
    std::fprintf(stderr, "usage: sentinel1_pass [data directory] [table to write, .csv]\n");
    return 1;
  }
  try {
    run(count > 1 ? words[1] : VECTRIX_EXAMPLE_DATA, count > 2 ? words[2] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sentinel1_pass: %s\n", error.what());
    return 1;
  }
  return 0;
}

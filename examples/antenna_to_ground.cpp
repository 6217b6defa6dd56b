// When does a cubesat's antenna reach a ground station, and how well? A day of passes.
//
//     Satellite --- Teme --- Itrf --- Gcrf --- Body --- Antenna
//                             |
//                          Station
//
//     r^teme, v^teme      SGP4 from two-line elements, v the derivative of r; axes of Satellite as of Teme
//     R_itrf^gcrf, w      IAU 2006/2000A over the day, with sub-daily tides: EarthMotion
//     R_itrf^teme, w      the same by the sidereal time of 1982: the Earth as SGP4 sees it
//     X_station^itrf      east, north, up at the place
//     R_gcrf^body         z to nadir, y along -(r x v): lvlh() of what the graph knows of Satellite
//     R_body^antenna      tilted about y by 30 deg: the boresight, z of the antenna, looks forward
//
// Every question is a path through the graph, at one instant:
//     azimuth, elevation, range and their rates      r and v of Satellite relative to Station, in Station
//     the angle of the station from the boresight    r of Station relative to Satellite, in Antenna
//     the angle of the Sun from that line            its direction seen from Satellite, in Antenna
// A pass is an interval of time in which a function is positive: elevation less 5 deg. The highest point is
// where the elevation's rate is zero.
//
// Expected results: an orbit 450 km high is seen for up to 9 min, almost 2000 km away at 5 deg; the range
// rate changes its sign at the highest point and is 7 km/s at most. The antenna looks forward: it sees the
// station while the cubesat comes.
//
//     antenna_to_ground [data directory]

#include <cstdio>
#include <exception>
#include <filesystem>

#include <vectrix/space.hpp>

#ifndef VECTRIX_EXAMPLE_DATA
#define VECTRIX_EXAMPLE_DATA "examples/data"
#endif

namespace {

using namespace vectrix;
using earth::Gcrf, earth::Itrf, earth::Teme;

struct Satellite : moving_frame {};
struct Body : moving_frame {};
struct Antenna : moving_frame {};
struct Station : east_north_up_frame {};

Quantity<si::angle> degrees(double angle) {
  return convert<si::angle>(angle * si::degree);
}

void run(const std::filesystem::path& data) {
  const auto orientation = EarthOrientation::read(data / "finals2000A_april_2023.txt");
  const auto set = TwoLineElements::read(data / "CTIM_20230419.tle").front();
  const auto day = from_until(set.epoch(), 1.0 * si::day);
  const Sgp4<Satellite> orbit(set, at_most(1.0 * si::day));
  const EarthMotion earth(orientation, day, subdaily_tides);
  const Ephemeris<sky::Sun> sun(day);
  const Geodetic boulder{GeodeticLatitude(degrees(40.015)), degrees(-105.27), 1650.0 * si::metre};

  const auto graph = frame_graph(edge(earth), edge(teme(earth)), edge(path(orbit)),
                                 rigid_edge(east_north_up(from<Station>, boulder)),
                                 edge([](const Displacement<Gcrf, Satellite, In<Gcrf>>& r,
                                         const Velocity<Gcrf, Satellite, ObservedFrom<Gcrf>, In<Gcrf>>& v) {
                                   return lvlh(from<Body>, r, v);
                                 }),
                                 rigid_edge(turned_y(to<Antenna>, from<Body>, degrees(30))));

  const auto look = [](const auto& now) {
    return look_angles(
        now.position(of<Satellite>, relative_to<Station>, in<Station>),
        now.velocity(of<Satellite>, relative_to<Station>, observed_from<Station>, in<Station>));
  };

  std::printf("%s over %.3f deg north, %.3f deg east, from %s UTC.\n", set.title().c_str(),
              boulder.latitude.angle.in(si::degree), boulder.longitude.in(si::degree),
              set.epoch().utc(0).c_str());
  const auto step = 60.0 * si::second;
  for (const TimeSpan& pass :
       intervals(day, step, [&](const Epoch& t) { return look(graph.at(t)).elevation - degrees(5); })) {
    const auto tops = events(pass, step, [&](const Epoch& t) { return look(graph.at(t)).elevation_rate; });
    if (tops.empty()) continue;  // it began before the day, or ends after it
    const Epoch& top = tops.front().epoch;
    std::printf("\n%s to %s, highest %.2f deg at %s\n", pass.start().utc(0).substr(11).c_str(),
                pass.end().utc(0).substr(11).c_str(), look(graph.at(top)).elevation.in(si::degree),
                top.utc(0).substr(11).c_str());
    std::printf("%10s %9s %9s %9s %9s %9s %9s\n", "UTC", "azimuth", "elevation", "range", "its rate",
                "boresight", "Sun");
    std::printf("%10s %9s %9s %9s %9s %9s %9s\n", "", "deg", "deg", "km", "km/s", "deg off", "deg off");
    for (const Epoch& t : every(step, pass)) {
      const auto now = graph.at(t);
      const auto line = now.position(of<Station>, relative_to<Satellite>, in<Antenna>);
      const auto to_sun = sun.direction(now, seen_from<Satellite>, apparent, in<Antenna>);
      const auto seen = look(now);
      std::printf("%10s %9.3f %9.3f %9.2f %9.4f %9.3f %9.3f\n", t.utc(0).substr(11).c_str(),
                  seen.azimuth.in(si::degree), seen.elevation.in(si::degree), seen.range.in(si::kilometre),
                  1e-3 * seen.range_rate.value(), angle_between(line, unit_z(in<Antenna>)).in(si::degree),
                  angle_between(line, to_sun).in(si::degree));
    }
  }
}

}  // namespace

int main(int count, char** words) {
  try {
    run(count > 1 ? words[1] : VECTRIX_EXAMPLE_DATA);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "antenna_to_ground: %s\n", error.what());
    return 1;
  }
  return 0;
}

/// Earth, orbits, sky and fields, compared with ERFA and GeographicLib in the same run. Prints a section of
/// docs/evidence/performance.md. Fails if a result differs from the peer's by more than its row allows; some
/// rows have no such bound.
#include <erfa.h>
#include <erfam.h>

#include <GeographicLib/Geocentric.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <vectrix/space.hpp>

#include "bursts.hpp"
#include "random_harmonics.hpp"
#include "timing.hpp"

namespace bench {
namespace {

using namespace vectrix;
using earth::Gcrf, earth::Itrf;

struct Satellite : moving_frame {};
struct Lvlh : moving_frame {};
struct Antenna : moving_frame {};
struct Station : east_north_up_frame {};

int run() {
  std::mt19937_64 generator(3);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(generator);
  };
  const auto start = Epoch::from_utc("2022-04-12T00:00:00");
  std::vector<Epoch> epochs;
  std::vector<Vector<Itrf, si::length>> places;
  std::vector<PointMotion<Gcrf, Satellite, Gcrf>> states;
  constexpr auto mu = Quantity<si::gravitational_parameter>::from_value(3.986004418e14);
  for (std::size_t i = 0; i < inputs; ++i) {
    epochs.push_back(start + uniform(0.0, 4.0 * 86400.0) * si::second);
    places.push_back(wgs84::position({GeodeticLatitude(uniform(-1.5, 1.5) * si::radian),
                                      uniform(-3.1, 3.1) * si::radian, uniform(2e5, 1e6) * si::metre}));
    const Eigen::Vector3d r(uniform(6e6, 7e6), uniform(-3e6, 3e6), uniform(-3e6, 3e6));
    states.push_back(
        point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>, vector<si::length>(in<Gcrf>, r),
                     vector<si::velocity>(in<Gcrf>, Eigen::Vector3d(uniform(-1e3, 1e3), 6e3, 4e3))));
  }
  std::vector<std::array<double, 2>> tt;
  for (const Epoch& t : epochs) tt.push_back({t.tt_date().day, t.tt_date().fraction});

  std::vector<Row> rows;
  const auto span = from_until(start, 5.0 * 86400.0 * si::second);

  const auto orientation = EarthOrientation::read(VECTRIX_EXAMPLE_DATA "/finals2000A_april_2022.txt");
  const EarthMotion earth(orientation, span), with_tides(orientation, span, subdaily_tides);
  const auto era_rotation = [&](std::size_t i) {
    const auto p = orientation.parameters(epochs[i]);
    const auto ut1 = epochs[i].julian_date(scale::tai);
    double matrix[3][3];
    eraC2t06a(tt[i][0], tt[i][1], ut1.day, ut1.fraction + p.ut1_minus_tai.value() / 86400.0, p.pole_x.value(),
              p.pole_y.value(), matrix);
    return Eigen::Matrix3d(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&matrix[0][0]));
  };
  const Task era_earth{"eraC2t06a", [&](std::size_t i) { keep(era_rotation(i)); }};
  const auto earth_difference = [&] {
    return largest_over_inputs([&](std::size_t i) {
      return (earth.rotation(epochs[i]).matrix().transpose() - era_rotation(i)).cwiseAbs().maxCoeff();
    });
  };
  constexpr double left_out = 5e-9;  // eraC2t06a has no dX and dY
  rows.push_back({{"Earth, R", [&](std::size_t i) { keep(earth.rotation(epochs[i])); }},
                  era_earth,
                  1.0 / 800.0,
                  earth_difference,
                  left_out});
  rows.push_back({{"Earth, R, w and alpha", [&](std::size_t i) { keep(earth.at(epochs[i])); }},
                  era_earth,
                  1.0 / 450.0,
                  nullptr,
                  0.0});
  rows.push_back({{"the same with sub-daily tides", [&](std::size_t i) { keep(with_tides.at(epochs[i])); }},
                  era_earth,
                  1.0 / 300.0,
                  nullptr,
                  0.0});
  rows.push_back(
      {{"Earth in TEME, R, w and alpha", [&](std::size_t i) { keep(teme_from_itrf(epochs[i], with_tides)); }},
       {"the same without a span, R and w",
        [&](std::size_t i) {
          keep(teme_from_itrf(epochs[i], orientation.parameters(epochs[i], subdaily_tides)));
        }},
       0.0,
       [&] {
         return largest_over_inputs([&](std::size_t i) {
           const auto exact = teme_from_itrf(epochs[i], orientation.parameters(epochs[i], subdaily_tides));
           return (teme_from_itrf(epochs[i], with_tides).rotation.matrix() - exact.rotation.matrix())
               .cwiseAbs()
               .maxCoeff();
         });
       },
       5e-12});  // a microarcsecond

  const Ephemeris<sky::Sun> sun(span);
  const auto era_sun = [&](std::size_t i) {
    double heliocentric[2][3], barycentric[2][3];
    eraEpv00(tt[i][0], tt[i][1], heliocentric, barycentric);
    return Eigen::Vector3d(-ERFA_DAU * heliocentric[0][0], -ERFA_DAU * heliocentric[0][1],
                           -ERFA_DAU * heliocentric[0][2]);
  };
  rows.push_back({{"Sun, r and v", [&](std::size_t i) { keep(sun.motion(epochs[i])); }},
                  {"eraEpv00", [&](std::size_t i) { keep(era_sun(i)); }},
                  1.0 / 800.0,
                  [&] {
                    return largest_over_inputs([&](std::size_t i) {
                      return (sun.motion(epochs[i]).position.coordinates() - era_sun(i)).norm();
                    });
                  },
                  60.0});  // m: TT for TDB, 2 ms of 30 km/s

  const Ephemeris<sky::Moon> moon(span);
  const auto era_moon = [&](std::size_t i) {
    double pv[2][3];
    eraMoon98(tt[i][0], tt[i][1], pv);
    return Eigen::Vector3d(ERFA_DAU * pv[0][0], ERFA_DAU * pv[0][1], ERFA_DAU * pv[0][2]);
  };
  rows.push_back({{"Moon, r and v", [&](std::size_t i) { keep(moon.motion(epochs[i])); }},
                  {"eraMoon98", [&](std::size_t i) { keep(era_moon(i)); }},
                  1.0 / 90.0,
                  [&] {
                    return largest_over_inputs([&](std::size_t i) {
                      return (moon.motion(epochs[i]).position.coordinates() - era_moon(i)).norm();
                    });
                  },
                  1.0});

  MeanElements elements =
      TwoLineElements::parse("1 25544U 98067A   08264.51782528 -.00002182  00000-0 -11606-4 0  2927",
                             "2 25544  51.6416 247.4627 0006703 130.5360 325.0288 15.72125391563537")
          .mean_elements();
  elements.epoch = start;
  const Sgp4<Satellite> orbit(elements, at_most(convert<si::time>(168.0 * si::hour)));
  const auto planet = [&](std::size_t i) {
    double pv[2][3];
    eraPlan94(tt[i][0], tt[i][1], 3, pv);
    keep(pv);
  };
  rows.push_back({{"SGP4 near the Earth, r and v", [&](std::size_t i) { keep(orbit.at(epochs[i])); }},
                  {"eraPlan94, a yardstick", planet},
                  0.0,
                  nullptr,
                  0.0});
  rows.push_back({{"its r and three derivatives", [&](std::size_t i) { keep(orbit.path(epochs[i])); }},
                  {"its r and v", [&](std::size_t i) { keep(orbit.at(epochs[i])); }},
                  0.0,
                  nullptr,
                  0.0});

  // From antenna to ground station: SGP4, the Earth with tides, an orbit frame, a mounting and a site.
  const Geodetic site{GeodeticLatitude(0.7 * si::radian), -1.8 * si::radian, 1650.0 * si::metre};
  const auto graph = frame_graph(
      edge(teme(with_tides)), edge(orbit), rigid_edge(east_north_up(from<Station>, site)),
      edge([](const Displacement<earth::Teme, Satellite, In<earth::Teme>>& r,
              const Velocity<earth::Teme, Satellite, ObservedFrom<earth::Teme>, In<earth::Teme>>& v) {
        return lvlh(from<Lvlh>, r, v);
      }),
      rigid_edge(turned_y(to<Antenna>, from<Lvlh>, 0.5 * si::radian)));
  rows.push_back({{"antenna to ground station, r in the antenna",
                   [&](std::size_t i) {
                     keep(graph.at(epochs[i]).position(of<Station>, relative_to<Satellite>, in<Antenna>));
                   }},
                  {"its SGP4 and its Earth alone",
                   [&](std::size_t i) {
                     keep(orbit.at(epochs[i]));
                     keep(teme_from_itrf(epochs[i], with_tides));
                   }},
                  0.0,
                  nullptr,
                  0.0});
  rows.push_back({{"two bodies, a quarter of an hour",
                   [&](std::size_t i) { keep(two_body(mu, states[i], 900.0 * si::second)); }},
                  {"eraPlan94, a yardstick", planet},
                  0.0,
                  nullptr,
                  0.0});

  const auto& geocentric = GeographicLib::Geocentric::WGS84();
  const auto their_geodetic = [&](std::size_t i) {
    const auto& r = places[i].coordinates();
    double latitude, longitude, height;
    geocentric.Reverse(r.x(), r.y(), r.z(), latitude, longitude, height);
    return std::array{latitude * std::numbers::pi / 180.0, longitude * std::numbers::pi / 180.0, height};
  };
  rows.push_back({{"geodetic", [&](std::size_t i) { keep(wgs84::geodetic(places[i])); }},
                  {"GeographicLib, Geocentric", [&](std::size_t i) { keep(their_geodetic(i)); }},
                  0.55,
                  [&] {
                    return largest_over_inputs([&](std::size_t i) {
                      return wgs84::geodetic(places[i]).latitude.angle.value() - their_geodetic(i)[0];
                    });
                  },
                  1e-15});

  const RandomHarmonics low(20), high(70), magnetic(13);
  const auto add_gravity = [&](const GravityField& field, const GeographicLib::SphericalHarmonic& harmonic) {
    const auto theirs = [&](std::size_t i) {
      const auto& r = places[i].coordinates();
      Eigen::Vector3d g;
      keep(harmonic(r.x(), r.y(), r.z(), g.x(), g.y(), g.z()));
      return Eigen::Vector3d(3.986004415e14 / 6378136.3 * g);
    };
    const std::string degree = "gravity to degree " + std::to_string(field.degree());
    const auto difference = [&, theirs] {
      return largest_over_inputs([&](std::size_t i) {
        return (field.acceleration(places[i]).coordinates() - theirs(i)).norm() / theirs(i).norm();
      });
    };
    const Task peer{"GeographicLib, SphericalHarmonic", [theirs](std::size_t i) { keep(theirs(i)); }};
    rows.push_back({{degree, [&](std::size_t i) { keep(field.acceleration(places[i])); }},
                    peer,
                    0.22,
                    difference,
                    1e-14});
    rows.push_back(
        {{degree + ", with gradient", [&](std::size_t i) { keep(field.with_gradient(places[i])); }},
         peer,
         0.30,
         nullptr,
         0.0});
  };
  const GravityField low_ours = low.ours(), high_ours = high.ours();
  const auto low_theirs = low.theirs(GeographicLib::SphericalHarmonic::FULL),
             high_theirs = high.theirs(GeographicLib::SphericalHarmonic::FULL);
  add_gravity(low_ours, low_theirs);
  add_gravity(high_ours, high_theirs);

  const auto field = MagneticField::igrf14();
  const auto schmidt = magnetic.theirs(GeographicLib::SphericalHarmonic::SCHMIDT);
  rows.push_back({{"IGRF-14, B", [&](std::size_t i) { keep(field.at(places[i], epochs[i])); }},
                  {"GeographicLib, SphericalHarmonic of its degree",
                   [&](std::size_t i) {
                     const auto& r = places[i].coordinates();
                     Eigen::Vector3d B;
                     keep(schmidt(r.x(), r.y(), r.z(), B.x(), B.y(), B.z()));
                     keep(B);
                   }},
                  0.32,
                  nullptr,
                  0.0});

  const auto with_rate = [&](std::size_t i) {
    return lvlh(from<Lvlh>, states[i], two_body_acceleration(mu, states[i].position));
  };
  rows.push_back({{"orbit frame, R, w and alpha",
                   [&](std::size_t i) {
                     const auto a = two_body_acceleration(mu, states[i].position);
                     keep(lvlh(from<Lvlh>, states[i], a, two_body_jerk(mu, states[i])));
                   }},
                  {"the same, R and w", [&](std::size_t i) { keep(with_rate(i)); }},
                  2.2,
                  nullptr,
                  0.0});

  for (const Row& row : rows) {
    if (row.difference && !(row.difference() <= row.allowed)) {
      std::fprintf(stderr, "space: %s and %s differ by %g\n", row.ours.name.c_str(), row.peer.name.c_str(),
                   row.difference());
      return 1;
    }
  }
  measure(rows);
  std::printf(
      "## Earth, orbits, sky and fields\n\n"
      "g++, x86-64, at random epochs and places, the tenth percentile of interleaved bursts of 20 us. The "
      "peers are "
      "Debian's ERFA and GeographicLib. SphericalHarmonic gives the acceleration alone; its coefficients are "
      "those of "
      "the row, except for IGRF-14, where only the degree is the same. eraPlan94 is no peer, but a "
      "well-known "
      "amount of work.\n\n"
      "| work | ns | peer | ns | ratio | target |\n| --- | --- | --- | --- | --- | --- |\n");
  print(rows);
  return 0;
}

}  // namespace
}  // namespace bench

int main() {
  return bench::run();
}

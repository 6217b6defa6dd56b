#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <vectrix/space.hpp>

#include "comparison.hpp"

namespace vectrix::validation {
namespace {

using earth::Gcrf, earth::Itrf, earth::Teme;

struct Satellite : moving_frame {};
struct Instrument : moving_frame {};
struct Body : moving_frame {};
struct Site : north_east_down_frame {};

const std::filesystem::path figures = VECTRIX_SPACE_DATA;
const std::filesystem::path flight = VECTRIX_EXAMPLE_DATA;

constexpr double arcsecond = 4.84813681109536e-6;  // rad

Quantity<si::angle> degrees(double angle) {
  return convert<si::angle>(angle * si::degree);
}
Quantity<si::angle> arcseconds(double angle) {
  return convert<si::angle>(angle * si::arcsecond);
}

// The largest difference of the rows of a table.
class Largest {
 public:
  void add(double difference) {
    value_ = std::max(value_, std::isnan(difference) ? HUGE_VAL : std::abs(difference));
  }
  [[nodiscard]] double value() const { return value_; }

 private:
  double value_ = 0.0;
};

Rows earth_rows() {
  const auto table = CsvTable::read(figures / "gcrs_to_itrs_20_epochs.csv", {});
  Largest celestial_to_terrestrial, true_of_date;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto number = [&](const char* column) { return table.number(i, column); };
    const auto epoch = Epoch::from_utc_mjd(static_cast<int>(number("mjd_utc_int")), number("frac_day_utc"));
    const EarthOrientationParameters observed{arcseconds(number("xp_arcsec")),
                                              arcseconds(number("yp_arcsec")),
                                              number("dut1_s") * si::second - epoch.tai_minus_utc(),
                                              Quantity<si::dimensionless>{0.0},
                                              arcseconds(1e-3 * number("dX_mas")),
                                              arcseconds(1e-3 * number("dY_mas"))};
    const Dcm<Itrf, Gcrf> R_itrf_from_gcrf = inverse(earth_rotation(epoch, observed).rotation);
    const auto R_true_from_gcrf = true_of_date_from_gcrf(epoch).rotation;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        const auto entry = [&](const char* letter) {
          return table.number(i, letter + std::to_string(row + 1) + std::to_string(column + 1));
        };
        celestial_to_terrestrial.add(R_itrf_from_gcrf.matrix()(row, column) - entry("C"));
        true_of_date.add(R_true_from_gcrf.matrix()(row, column) - entry("B"));
      }
    }
  }
  constexpr const char* reason = "the same models by ERFA, 17 digits";
  return {{"Earth", "20 epochs, 1973 to 2024", "R_gcrf^itrf, each entry", 1e-12, "", reason,
           celestial_to_terrestrial.value()},
          {"Earth", "20 epochs, 1973 to 2024", "R_gcrf^true of date, each entry", 1e-12, "", reason,
           true_of_date.value()}};
}

Rows sgp4_rows() {
  std::map<int, Sgp4<Satellite>> orbits;
  Largest place, speed;
  std::size_t states_compared = 0;
  for (const std::string name : {"sgp4", "sgp4_later"}) {
    for (const auto& set : TwoLineElements::read(figures / (name + "_sets.tle"))) {
      orbits.emplace(set.catalogue_number(),
                     Sgp4<Satellite>(set, at_most(convert<si::time>(35064.0 * si::hour))));
    }
    const auto table = CsvTable::read(figures / (name + "_states.csv"), {"norad", "t_min"});
    states_compared += table.rows();
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const auto& orbit = orbits.at(static_cast<int>(table.number(i, "norad")));
      const auto now =
          orbit.at(orbit.elements().epoch + convert<si::time>(table.number(i, "t_min") * si::minute));
      const auto r = read_vector<si::length>(in<Teme>, table, i, {"x_km", "y_km", "z_km"}).coordinates();
      const auto v =
          read_vector<si::velocity>(in<Teme>, table, i, {"vx_kms", "vy_kms", "vz_kms"}).coordinates();
      place.add((1e-3 * now.position.coordinates() - r).norm());
      speed.add((1e-3 * now.velocity.coordinates() - v).norm());
    }
  }
  constexpr const char* reason =
      "8 and 9 printed decimals; their epoch is one double, good to 2e-5 s, which sets a deep orbit's "
      "resonance off: states of set 23333 that it moves by more are not among them";
  const std::string states = "SGP4, " + std::to_string(orbits.size()) + " sets of AIAA 2006-6753, " +
                             std::to_string(states_compared) + " states";
  return {{"Orbits", states, "position", 1e-6, "km", reason, place.value()},
          {"Orbits", states, "velocity", 1e-9, "km/s", reason, speed.value()}};
}

Rows element_rows() {
  constexpr auto mu = Quantity<si::gravitational_parameter>::from_value(3.986004418e14);
  const auto table = CsvTable::read(figures / "modified_equinoctial.csv", {"case"});
  Largest elements, states;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto at = [&](const char* column) { return table.number(i, column); };
    const auto r = 1e3 * read_vector<si::length>(in<Gcrf>, table, i, {"x_km", "y_km", "z_km"});
    const auto v = 1e3 * read_vector<si::velocity>(in<Gcrf>, table, i, {"vx_km_s", "vy_km_s", "vz_km_s"});
    const auto x = modified_equinoctial(
        prograde, mu, point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>, r, v));
    elements.add(x.semi_latus_rectum().value() / (1e3 * at("p_km")) - 1.0);
    for (const double difference : {x.f() - at("f"), x.g() - at("g"), x.h() - at("h"), x.k() - at("k")}) {
      elements.add(difference);
    }
    const auto given = modified_equinoctial(prograde, of<Satellite>, relative_to<Gcrf>, in<Gcrf>,
                                            1e3 * at("p_km") * si::metre, at("f"), at("g"), at("h"), at("k"),
                                            degrees(at("L_deg")));
    states.add((point_motion(mu, given).position.coordinates() - r.coordinates()).norm() / norm(r).value());
  }
  return {{"Orbits", "modified equinoctial elements, GMAT's tests", "p, relative; f, g, h, k", 9e-9, "",
           "the figures agree with the definition to 9e-9", elements.value()},
          {"Orbits", "the same, back", "position, relative", 2.2e-8, "",
           "an arc cosine near 1 has set the longitude of one row off by 1.2e-6 deg", states.value()}};
}

// Orekit's EclipseDetectorTest: two bodies alone, a spherical Earth of 6400 km, a Sun of 696000 km,
// geometric.
Rows eclipse_rows() {
  constexpr auto mu = Quantity<si::gravitational_parameter>::from_value(3.9860047e14);
  const auto start = Epoch::from_tt("1969-07-28T04:00:00");
  const auto first =
      point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>,
                   vector<si::length>(in<Gcrf>, Eigen::Vector3d(-6142438.668, 3492467.56, -25767.2568)),
                   vector<si::velocity>(in<Gcrf>, Eigen::Vector3d(505.8479685, 942.7809215, 7435.922231)));
  const auto span = from_until(start, 5000.0 * si::second);
  const Ephemeris<sky::Sun> sun(span);
  const auto seen = [&](const Epoch& t) {
    const auto r = two_body(mu, first, t - start).position;
    return visible_sun(sun.line_of_sight(t, r, geometric), -r, 6.4e6 * si::metre, 6.96e8 * si::metre);
  };
  // The Sun's disc is uncovered as the power 3/2 of time: 1e-10 of it in 2e-6 s.
  constexpr double sliver = 1e-10;
  const auto step = 10.0 * si::second;
  const auto dark = events(span, step, [&](const Epoch& t) { return seen(t) - sliver; });
  const auto bright = events(span, step, [&](const Epoch& t) { return seen(t) - (1.0 - sliver); });
  if (dark.size() != 2 || bright.size() != 2) throw std::runtime_error("eclipse: not one eclipse");
  const auto after = [&](const ZeroCrossing& event) { return (event.epoch - start).value(); };
  constexpr const char* reason = "an independent integration, with the same Sun, printed to 1e-6 s";
  return {{"Sky", "umbra entry of a low orbit, Orekit's test", "time", 1e-5, "s", reason,
           std::abs(after(dark[0]) - 2303.183486)},
          {"Sky", "penumbra exit of a low orbit, Orekit's test", "time", 1e-5, "s", reason,
           std::abs(after(bright[1]) - 4388.155843)}};
}

// Two eclipses of the Sun where they were greatest, as F. Espenak, NASA's GSFC, published them: with a Sun of
// 959.63 arcsec at 1 au, and a Moon of 0.272281 equatorial radii where it covers the Sun or lies within it.
struct SolarEclipse {
  const char* from;                           // UTC
  double latitude, longitude, ut1_minus_utc;  // deg, deg, s
};
class SeenFromTheGround {
 public:
  explicit SeenFromTheGround(const SolarEclipse& eclipse)
      : span_(from_until(Epoch::from_utc(eclipse.from), 1800.0 * si::second)),
        earth_(EarthOrientation::unobserved(span_, eclipse.ut1_minus_utc * si::second), span_),
        sun_(span_),
        moon_(span_),
        place_(wgs84::position(
            {GeodeticLatitude(degrees(eclipse.latitude)), degrees(eclipse.longitude), 0.0 * si::metre})) {}

  // The part of the Sun's disc that is covered.
  [[nodiscard]] double covered(const Epoch& t) const {
    const auto graph = frame_graph(
        edge(earth_), rigid_edge(Transform{aligned(to<Itrf>, from<Satellite>),
                                           displacement(of<Satellite>, relative_to<Itrf>, place_)}));
    const auto now = graph.at(t);
    return 1.0 - visible_sun(sun_.line_of_sight(now, seen_from<Satellite>, apparent, in<Gcrf>),
                             moon_.line_of_sight(now, seen_from<Satellite>, apparent, in<Gcrf>),
                             0.272281 * wgs84::semi_major_axis, 6.96e8 * si::metre);
  }
  [[nodiscard]] const TimeSpan& span() const { return span_; }
  // While more than this part is covered.
  [[nodiscard]] TimeSpan longest(double part) const {
    const auto found = intervals(span_, 5.0 * si::second, [&](const Epoch& t) {
      return Quantity<si::dimensionless>{covered(t) - part};
    });
    if (found.size() != 1) throw std::runtime_error("solar eclipse: not one interval");
    return found.front();
  }

 private:
  TimeSpan span_;
  EarthMotion earth_;
  Ephemeris<sky::Sun> sun_;
  Ephemeris<sky::Moon> moon_;
  Vector<Itrf, si::length> place_;
};

Rows solar_eclipse_rows() {
  const SeenFromTheGround total({"2017-08-21T18:10:00", 36.0 + 58.0 / 60.0, -87.0 - 40.3 / 60.0, 0.34});
  const TimeSpan dark = total.longest(1.0 - 1e-10);
  const Epoch middle = dark.start() + 0.5 * (dark.end() - dark.start());
  const double later = (middle - Epoch::from_utc("2017-08-21T18:25:32")).value();
  const SeenFromTheGround annular({"2023-10-14T17:45:00", 11.4, -83.1, 0.0});
  double covered = 0.0;
  for (const Epoch& t : every(1.0 * si::second, annular.span()))
    covered = std::max(covered, annular.covered(t));
  return {{"Sky", "total eclipse of 2017, NASA's prediction", "duration", 6.0, "s",
           "eraMoon98 is up to 15 km off, in a shadow 115 km wide",
           std::abs((dark.end() - dark.start()).value() - 160.1)},
          {"Sky", "the same", "middle", 25.0, "s", "the shadow passes 15 km in 25 s", std::abs(later)},
          {"Sky", "annular eclipse of 2023, NASA's prediction", "covered part of the Sun", 1e-3, "",
           "three printed decimals; the Moon's distance", std::abs(covered - 0.907)}};
}

// The nominal attitude of two Galileo satellites, by Orekit's test of it.
Rows yaw_steering_rows() {
  const auto table = CsvTable::read(figures / "galileo_yaw_steering.csv", {"x_m", "sun_x_m", "axis_x"});
  Largest axis;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto r = displacement(of<Satellite>, relative_to<Gcrf>,
                                read_vector<si::length>(in<Gcrf>, table, i, {"x_m", "y_m", "z_m"}));
    const auto s =
        displacement(of<sky::Sun>, relative_to<Gcrf>,
                     read_vector<si::length>(in<Gcrf>, table, i, {"sun_x_m", "sun_y_m", "sun_z_m"}));
    const auto R_gcrf_from_body = yaw_steering(from<Body>, r, s - r);
    const auto x = read_vector<si::dimensionless>(in<Gcrf>, table, i, {"axis_x", "axis_y", "axis_z"});
    axis.add((R_gcrf_from_body * unit_x(in<Body>) - x).coordinates().norm());
  }
  return {{"Sky", "yaw steering of Galileo, Orekit's test", "x axis", 3e-14, "rad", "14 printed decimals",
           axis.value()}};
}

// The cosines that the ground processing of CTIM, a cubesat, gave for its radiometer.
Rows flight_rows() {
  const auto attitude = CsvTable::read(flight / "CTIM_20230420_attitude.csv", {"UTC"});
  std::vector<AttitudeSample<Satellite, Gcrf, Epoch>> samples;
  for (std::size_t i = 0; i < attitude.rows(); ++i) {
    const auto q = [&](const char* column) { return 5e-10 * attitude.number(i, column); };
    samples.push_back(
        {attitude.value(i, "UTC", Epoch::from_utc),
         nearest_quaternion_scalar_first(to<Satellite>, from<Gcrf>, q("quaternion_c"), q("quaternion_x"),
                                         q("quaternion_y"), q("quaternion_z"))
             .quaternion});
  }
  const SampledAttitude turning(samples, 30.0 * si::second);
  const auto R_satellite_from_instrument =
      dcm(nearest_quaternion_scalar_first(to<Satellite>, from<Instrument>, 9.999876e-01, 1.534418e-03,
                                          4.728365e-03, -7.255375e-06)
              .quaternion);
  const auto orientation = EarthOrientation::read(flight / "finals2000A_april_2023.txt");
  const Sgp4<Satellite> orbit(TwoLineElements::read(flight / "CTIM_20230419.tle").front(),
                              at_most(convert<si::time>(24.0 * si::hour)));
  const auto span = from_until(samples.front().time, samples.back().time);
  const Ephemeris<sky::Sun> sun(span);
  const Ephemeris<sky::Moon> moon(span);
  const auto published = CsvTable::read(flight / "CTIM_20230420_pointing.csv", {"timdotsun", "timdotmoon"});
  Largest off_sun, off_moon;
  for (std::size_t i = 0; i < published.rows(); ++i) {
    const auto microseconds = static_cast<std::int64_t>(published.number(i, "microsecondssincegpsepoch"));
    const Epoch t = Epoch::from_gps_seconds(microseconds / 1'000'000);
    // r^gcrf = R_itrf^gcrf R_teme^itrf r^teme
    const auto to_gcrf =
        orientation.at(t).rotation * inverse(teme_from_itrf(t, orientation.parameters(t)).rotation);
    const auto r = displacement(of<Satellite>, relative_to<Gcrf>, to_gcrf * orbit.at(t).position.vector());
    const auto boresight =
        inverse(turning(t).rotation) * (R_satellite_from_instrument * -unit_z(in<Instrument>));
    const auto difference = [&](const auto& line, const char* column) {
      return (angle_between(boresight, line.vector()).value() - std::acos(published.number(i, column))) /
             arcsecond;
    };
    off_sun.add(difference(sun.line_of_sight(t, r, geometric), "timdotsun"));
    off_moon.add(difference(moon.line_of_sight(t, r, geometric), "timdotmoon"));
  }
  return {{"Sky", "CTIM, 719 epochs in flight", "boresight to the Sun", 0.019, "arcsec",
           "the digits of the quaternions, and some km of the place", off_sun.value()},
          {"Sky", "CTIM, 719 epochs in flight", "boresight to the Moon", 7.6, "arcsec",
           "eraMoon98's accuracy", off_moon.value()}};
}

Rows field_rows() {
  const auto gravity = CsvTable::read(figures / "egm2008_50_digits.csv", {"x_m", "gx_m_s2"});
  const auto egm = GravityField::egm2008(20);
  Largest attraction;
  for (std::size_t i = 0; i < gravity.rows(); ++i) {
    const auto r = read_vector<si::length>(in<Itrf>, gravity, i, {"x_m", "y_m", "z_m"});
    const auto g = read_vector<si::acceleration>(in<Itrf>, gravity, i, {"gx_m_s2", "gy_m_s2", "gz_m_s2"});
    attraction.add((egm.acceleration(r).coordinates() - g.coordinates()).norm() / norm(g).value());
  }
  const auto table = CsvTable::read(figures / "wmm2025_test_values.csv", {"x_nT", "y_nT", "z_nT"});
  const auto model = MagneticField::wmm2025();
  Largest field, change;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double year = table.number(i, "year"), whole = std::floor(year);
    const auto start = [](double y) {
      return Epoch::from_tt(std::to_string(static_cast<int>(y)) + "-01-01T00:00:00");
    };
    const Epoch t = start(whole) + (year - whole) * (start(whole + 1.0) - start(whole));
    const Geodetic place{GeodeticLatitude(degrees(table.number(i, "latitude_deg"))),
                         degrees(table.number(i, "longitude_deg")),
                         1e3 * table.number(i, "altitude_km") * si::metre};
    const auto R_site_from_itrf = inverse(north_east_down(from<Site>, place).rotation);
    const auto [B_itrf, rate_itrf] = model.with_rate(wgs84::position(place), t);
    const auto B_site = R_site_from_itrf * B_itrf;
    field.add(B_site.x().in(si::nanotesla)-table.number(i, "x_nT"));
    field.add(B_site.y().in(si::nanotesla)-table.number(i, "y_nT"));
    field.add(B_site.z().in(si::nanotesla)-table.number(i, "z_nT"));
    // nT/year
    const Eigen::Vector3d per_year = 1e9 * (start(whole + 1.0) - start(whole)).value() *
                                     (R_site_from_itrf * rate_itrf.vector()).coordinates();
    change.add(per_year.x() - table.number(i, "dx_nT_per_year"));
    change.add(per_year.y() - table.number(i, "dy_nT_per_year"));
    change.add(per_year.z() - table.number(i, "dz_nT_per_year"));
  }
  return {{"Fields", "EGM2008 to degree 20, " + std::to_string(gravity.rows()) + " points",
           "acceleration, relative", 1e-15, "",
           "20 digits, computed in 50 from the published coefficients; a few roundings", attraction.value()},
          {"Fields", "WMM2025, " + std::to_string(table.rows()) + " official test values", "each component",
           0.01, "nT", "their program's rounding; the publisher asks for 0.1 nT", field.value()},
          {"Fields", "the same", "each component of the secular variation", 0.01, "nT/year",
           "their program's rounding", change.value()}};
}

}  // namespace

Rows space_rows(const std::string& /*data*/) {
  Rows rows;
  for (const auto part : {earth_rows, sgp4_rows, element_rows, eclipse_rows, solar_eclipse_rows,
                          yaw_steering_rows, flight_rows, field_rows}) {
    const Rows more = part();
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace vectrix::validation

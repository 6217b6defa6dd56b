#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <vectrix/space/earth/ellipsoid.hpp>
#include <vectrix/space/fields/magnetic_field.hpp>
#include <vectrix/space/files/csv_table.hpp>

#include "temporary_file.hpp"

namespace vectrix::magnetic_field_test {
namespace {

using earth::Itrf;
using Eigen::Vector3d;

const std::filesystem::path source = VECTRIX_SOURCE_DIR;

Epoch year(double decimal) {
  const double whole = std::floor(decimal);
  const auto start = [](double y) { return Epoch::from_tt(detail::text(y) + "-01-01T00:00:00"); };
  return start(whole) + (decimal - whole) * (start(whole + 1) - start(whole));
}
Vector<Itrf, si::length> at(double x, double y, double z) {
  return vector<si::length>(in<Itrf>, Vector3d(x, y, z));
}
Vector3d nanotesla(const Vector<Itrf, si::magnetic_flux_density>& B) {
  return {B.x().in(si::nanotesla), B.y().in(si::nanotesla), B.z().in(si::nanotesla)};
}

// The model's publishers ask for 0.1 nT; the values are printed to 0.1 nT or better.
TEST(MagneticField, ReproducesTheTestValuesOfTheWorldMagneticModel) {
  constexpr double printed_to = 0.01;  // nT
  const auto table =
      CsvTable::read(source / "space/tests/data/wmm2025_test_values.csv",
                     {"year", "altitude_km", "latitude_deg", "longitude_deg", "x_nT", "dx_nT_per_year"});
  ASSERT_GT(table.rows(), 50U);
  const MagneticField model = MagneticField::wmm2025();
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto angle = [&](const char* column) {
      return convert<si::angle>(table.number(i, column) * si::degree);
    };
    const auto latitude = angle("latitude_deg"), longitude = angle("longitude_deg");
    const auto r = wgs84::position(
        {GeodeticLatitude(latitude), longitude, 1e3 * table.number(i, "altitude_km") * si::metre});
    const double decimal = table.number(i, "year");
    const auto [field, rate] = model.with_rate(r, year(decimal));
    const Vector3d B = nanotesla(field);
    EXPECT_EQ(B, nanotesla(model.at(r, year(decimal)))) << i;
    const double of_a_year = (year(std::floor(decimal) + 1.0) - year(std::floor(decimal))).value();
    const Vector3d dB = 1e9 * of_a_year * rate.vector().coordinates();
    const double sp = std::sin(latitude.value()), cp = std::cos(latitude.value());
    const double sl = std::sin(longitude.value()), cl = std::cos(longitude.value());
    const Vector3d north(-sp * cl, -sp * sl, cp), east(-sl, cl, 0.0), down(-cp * cl, -cp * sl, -sp);
    EXPECT_NEAR(B.dot(north), table.number(i, "x_nT"), printed_to) << i;
    EXPECT_NEAR(B.dot(east), table.number(i, "y_nT"), printed_to) << i;
    EXPECT_NEAR(B.dot(down), table.number(i, "z_nT"), printed_to) << i;
    EXPECT_NEAR(dB.dot(north), table.number(i, "dx_nT_per_year"), printed_to) << i;
    EXPECT_NEAR(dB.dot(east), table.number(i, "dy_nT_per_year"), printed_to) << i;
    EXPECT_NEAR(dB.dot(down), table.number(i, "dz_nT_per_year"), printed_to) << i;
  }
}

// Far away only the dipole of 2020.0 is left (IGRF-14: g10, g11, h11). The quadrupole is a tenth of it, and
// falls by one more power of the distance.
TEST(MagneticField, FarAwayIsTheDipole) {
  const Vector3d m(-1451.37, 4653.35, -29403.41);
  const double a = 6371.2e3;
  for (const Vector3d& direction : {Vector3d(0.6, 0.64, -0.48), Vector3d(0, 0, 1), Vector3d(-0.6, 0, 0.8)}) {
    const double distance = 1e11;
    const Vector3d B = nanotesla(MagneticField::igrf14().at(
        at(distance * direction.x(), distance * direction.y(), distance * direction.z()), year(2020.0)));
    const Vector3d dipole = std::pow(a / distance, 3) * (3 * direction * direction.dot(m) - m);
    EXPECT_LE((B - dipole).norm(), 1e-3 * dipole.norm());
  }
}

TEST(MagneticField, IsLinearInTheTimeBetweenTheEpochsOfTheModel) {
  const MagneticField model = MagneticField::igrf14();
  const auto r = at(3e6, -5e6, 4e6);
  constexpr double rounding = 1e-9;  // nT, of 5e4 nT
  for (const double start : {1900.0, 1955.0, 2015.0, 2025.0}) {
    // Each five years hold a leap year: parts of a year are parts of its own length.
    const auto B = [&](double t) { return nanotesla(model.at(r, year(t))); };
    EXPECT_LE((B(start + 2.5) - (B(start) + B(start + 5.0)) / 2).norm(), rounding) << start;
    EXPECT_GT((B(start + 5.0) - B(start)).norm(), 10.0) << start;
  }
  // Continuous where two spans meet.
  const auto before = nanotesla(model.at(r, year(2020.0) + -1.0 * si::second));
  EXPECT_LE((nanotesla(model.at(r, year(2020.0))) - before).norm(), 1e-4);
}

// A year of 365 days, within which the model is linear; at the end of a span the rate is that of the next
// one.
TEST(MagneticField, RateIsTheDerivative) {
  const MagneticField model = MagneticField::igrf14();
  const auto r = at(3e6, -5e6, 4e6);
  const auto rate = [&](const Epoch& t) -> Vector3d {
    return 1e9 * model.with_rate(r, t).rate.vector().coordinates();
  };
  const auto slope = [&](const Epoch& from, const Epoch& until) -> Vector3d {
    return (nanotesla(model.at(r, until)) - nanotesla(model.at(r, from))) / (until - from).value();
  };
  constexpr double rounding = 1e-17;  // nT/s: of 1e-11 nT in the field, over a year
  EXPECT_LE((rate(year(2013.5)) - slope(year(2013.0), year(2014.0))).norm(), rounding);
  EXPECT_LE((rate(year(2020.0)) - slope(year(2020.0), year(2021.0))).norm(), rounding);
  EXPECT_GT((rate(year(2020.0)) - rate(year(2019.5))).norm(), 1e-8);
  EXPECT_LE((rate(model.last()) - slope(year(2029.0), year(2030.0))).norm(), rounding);
}

// A graph answers where a satellite is: what it says is taken as it is.
TEST(MagneticField, TakesADisplacementFromTheCentreOfTheEarth) {
  struct Satellite : moving_frame {};
  const MagneticField model = MagneticField::wmm2025();
  const auto r = at(3e6, -5e6, 4e6);
  const auto t = model.first();
  EXPECT_EQ(model.at(displacement(of<Satellite>, relative_to<Itrf>, r), t).coordinates(),
            model.at(r, t).coordinates());
  EXPECT_EQ(model.at(displacement(of<Satellite>, relative_to<earth::Gcrf>, r), t).coordinates(),
            model.at(r, t).coordinates());
}

// The two models were made by different groups from mostly the same data: they agree to some tens of nT.
TEST(MagneticField, TheTwoModelsAgree) {
  const MagneticField igrf = MagneticField::igrf14(), wmm = MagneticField::wmm2025();
  for (const double z : {-6.8e6, -3e6, 0.0, 4e6, 6.8e6}) {
    const auto r = at(std::sqrt(6.9e6 * 6.9e6 - z * z), 0.0, z);
    EXPECT_LE((nanotesla(igrf.at(r, year(2026.5))) - nanotesla(wmm.at(r, year(2026.5)))).norm(), 100.0) << z;
  }
}

TEST(MagneticField, TurnsAMagnetorquer) {
  struct Body : moving_frame {};
  const auto B = vector(in<Body>, 0.0 * si::tesla, 0.0 * si::tesla, 3e-5 * si::tesla);
  const auto m = vector(in<Body>, 2.0 * si::ampere_square_metre, 0.0 * si::ampere_square_metre,
                        0.0 * si::ampere_square_metre);
  const Vector<Body, si::torque> torque = cross(m, B);
  EXPECT_EQ(torque.coordinates(), Vector3d(0, -6e-5, 0));
}

TEST(MagneticField, RefusesOtherTimesAndDepths) {
  const MagneticField model = MagneticField::wmm2025();
  const auto r = at(0, 0, 6.9e6);
  EXPECT_EQ(model.first().tt(0), "2025-01-01T00:00:00");
  EXPECT_EQ(model.last().tt(0), "2030-01-01T00:00:00");
  EXPECT_NO_THROW((void)model.at(r, model.first()));
  EXPECT_NO_THROW((void)model.at(r, model.last()));
  EXPECT_EQ(complaint([&] { (void)model.at(r, Epoch::from_tt("2024-12-31T23:59:59")); }),
            "MagneticField WMM2025: the epoch 2024-12-31T23:59:59.000000 TT is outside the model, "
            "2025-01-01T00:00:00 to 2030-01-01T00:00:00 TT");
  EXPECT_NE(complaint([&] {
              (void)MagneticField::igrf14().at(r, Epoch::from_tt("2030-01-01T00:00:01"));
            }).find("MagneticField IGRF-14"),
            std::string::npos);
  EXPECT_EQ(
      complaint([&] { (void)model.at(at(0, 0, 6.1e6), model.first()); }),
      "MagneticField WMM2025: the point is 6100000 m from the centre; the series holds outside the Earth");
}

}  // namespace
}  // namespace vectrix::magnetic_field_test

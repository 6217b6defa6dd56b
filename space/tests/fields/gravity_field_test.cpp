#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <sstream>
#include <vectrix/space/fields/gravity_field.hpp>

#include "temporary_file.hpp"
#include "testing/trials.hpp"

namespace vectrix::gravity_field_test {
namespace {

using earth::Itrf;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Wide = boost::multiprecision::cpp_bin_float_50;
using WidePoint = std::array<Wide, 3>;

constexpr double mu = 3.986004415e14, radius = 6378136.3;

struct Model {
  int degree;
  std::vector<std::array<double, 2>> coefficients;  // by degree, then order

  explicit Model(int highest) : degree(highest) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> number(-1e-4, 1e-4);
    for (int n = 0; n <= degree; ++n) {
      for (int m = 0; m <= n; ++m) {
        if (n < 2) {
          coefficients.push_back({n == 0 ? 1.0 : 0.0, 0.0});
        } else {
          const double C = n == 2 && m == 0 ? -4.8416e-4 : number(random), S = number(random);
          coefficients.push_back({C, m == 0 ? 0.0 : S});
        }
      }
    }
  }

  [[nodiscard]] std::string file(const char* exponent = "e") const {
    std::ostringstream out;
    out.precision(17);
    out << "A model of the test\n\nproduct_type gravity_field\nmodelname random\nearth_gravity_constant "
        << mu << "\nradius " << radius << "\nmax_degree " << degree
        << "\nnorm fully_normalized\nend_of_head ===\n";
    std::size_t i = 0;
    for (int n = 0; n <= degree; ++n) {
      for (int m = 0; m <= n; ++m, ++i) {
        out << "gfc " << n << ' ' << m << ' ' << std::scientific << coefficients[i][0] << ' '
            << coefficients[i][1] << " 0 0\n";
      }
    }
    std::string text = out.str();
    const auto head = text.find("end_of_head");
    for (auto at = text.find("e-", head); at != std::string::npos; at = text.find("e-", at + 1))
      text.replace(at, 1, exponent);
    return text;
  }

  /// The definition: associated Legendre functions from the powers of the polynomial's derivative.
  [[nodiscard]] Wide potential(const WidePoint& p) const {
    const Wide r = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), s = p[2] / r;
    const Wide c = sqrt(p[0] * p[0] + p[1] * p[1]) / r;
    const Wide longitude = atan2(p[1], p[0]);
    Wide sum = 0;
    std::size_t i = 0;
    for (int n = 0; n <= degree; ++n) {
      for (int m = 0; m <= n; ++m, ++i) {
        // P_nm(s) = c^m d^m/ds^m P_n(s),  P_n(s) = 2^-n sum_k (-1)^k (2n-2k)!/(k! (n-k)! (n-2k)!) s^(n-2k)
        Wide function = 0;
        for (int k = 0; 2 * k <= n - m; ++k) {
          const Wide term =
              factorial(2 * n - 2 * k) / (factorial(k) * factorial(n - k) * factorial(n - 2 * k - m));
          function += (k % 2 == 0 ? term : Wide(-term)) * pow(s, n - 2 * k - m);
        }
        function *= pow(c, m) / pow(Wide(2), n);
        const Wide norm = sqrt((m == 0 ? 1 : 2) * Wide(2 * n + 1) * factorial(n - m) / factorial(n + m));
        sum += pow(radius / r, n) * norm * function *
               (coefficients[i][0] * cos(m * longitude) + coefficients[i][1] * sin(m * longitude));
      }
    }
    return mu / r * sum;
  }

 private:
  static Wide factorial(int n) {
    Wide product = 1;
    for (int k = 2; k <= n; ++k) product *= k;
    return product;
  }
};

WidePoint wide(const Vector3d& r) {
  return {r.x(), r.y(), r.z()};
}
WidePoint moved(WidePoint p, std::size_t axis, const Wide& h) {
  p[axis] += h;
  return p;
}

/// Of 50 digits, 1e-20 of the distance is lost twice in a first difference, 1e-12 in a second.
Vector3d gradient(const Model& model, const Vector3d& r) {
  const Wide h = 1e-13;
  Vector3d g;
  for (std::size_t i = 0; i < 3; ++i) {
    const Wide change = model.potential(moved(wide(r), i, h)) - model.potential(moved(wide(r), i, -h));
    g(static_cast<Eigen::Index>(i)) = static_cast<double>(Wide(change / (2 * h)));
  }
  return g;
}
Matrix3d second_derivatives(const Model& model, const Vector3d& r) {
  const Wide h = 1e-5;
  Matrix3d G;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      Wide sum = 0;
      for (const int a : {1, -1}) {
        for (const int b : {1, -1}) sum += a * b * model.potential(moved(moved(wide(r), i, a * h), k, b * h));
      }
      G(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          static_cast<double>(Wide(sum / (4 * h * h)));
    }
  }
  return G;
}

Vector<Itrf, si::length> at(const Vector3d& r) {
  return vector<si::length>(in<Itrf>, r);
}

const std::vector<Vector3d>& points() {
  static const std::vector<Vector3d> list{{0.0, 0.0, 6.9e6},    {0.0, 0.0, -6.4e6},  {7e6, 0.0, 0.0},
                                          {-6.5e6, 0.0, 1.0},   {3e6, -5e6, 4e6},    {1e-3, -2e-3, 6.8e6},
                                          {-2e6, -6e6, -2.5e6}, {1.2e7, -3e7, 2.2e7}};
  return list;
}

// At the poles, on the equator and between, and beside the axis.
TEST(GravityField, IsTheGradientOfThePotentialByItsDefinition) {
  constexpr double rounding = 1e-15;  // of the whole: some units in the last place
  // The definition of the higher ones takes the sanitizers seconds.
  constexpr int highest = vectrix_test::one_in == 1 ? 9 : 4;
  const Model model(highest);
  const TemporaryFile file(model.file());
  const GravityField field = GravityField::read(file.path(), highest);
  for (const Vector3d& r : points()) {
    const Vector3d expected = gradient(model, r);
    const auto found = field.with_gradient(at(r));
    EXPECT_LE((field.acceleration(at(r)).coordinates() - expected).norm(), rounding * expected.norm())
        << r.transpose();
    EXPECT_LE((found.acceleration.coordinates() - expected).norm(), rounding * expected.norm());
    const Matrix3d G = second_derivatives(model, r);
    EXPECT_LE((found.gradient.matrix() - G).norm(), 2 * rounding * G.norm()) << r.transpose();
    EXPECT_LE(std::abs(found.gradient.matrix().trace()), rounding * G.norm());
  }
}

// To the degree asked for, and no further.
TEST(GravityField, EndsAtTheDegreeAskedFor) {
  const Model model(6);
  const TemporaryFile file(model.file());
  Model lower(4);
  std::copy_n(model.coefficients.begin(), lower.coefficients.size(), lower.coefficients.begin());
  const GravityField field = GravityField::read(file.path(), 4);
  EXPECT_EQ(field.degree(), 4);
  const Vector3d r(3e6, -5e6, 4e6), expected = gradient(lower, r);
  EXPECT_LE((field.acceleration(at(r)).coordinates() - expected).norm(), 1e-15 * expected.norm());
  const Vector3d central = GravityField::read(file.path(), 0).acceleration(at(r)).coordinates();
  EXPECT_LE((central + mu / std::pow(r.norm(), 3) * r).norm(), 1e-15 * central.norm());
}

// The oblateness alone: g = -mu r/r^3 + J2 terms (Vallado), with J2 = -sqrt(5) C20. EGM2008's J2
// is 1.08263e-3.
TEST(GravityField, OfDegreeTwoHasTheOblatenessOfTheEarth) {
  const GravityField field = GravityField::egm2008(2);
  EXPECT_EQ(field.mu().value(), mu);
  EXPECT_EQ(field.radius().value(), radius);
  const Vector3d r(3e6, -5e6, 4e6);
  const double J2 = 1.0826261738522e-3, d = r.norm(), z = r.z() * r.z() / (d * d);
  const double factor = 1.5 * J2 * mu * radius * radius / std::pow(d, 5);
  const Vector3d oblate(factor * r.x() * (5 * z - 1), factor * r.y() * (5 * z - 1),
                        factor * r.z() * (5 * z - 3));
  const Vector3d expected = -mu / (d * d * d) * r + oblate;
  // C22 is 2e-3 of C20.
  EXPECT_LE((field.acceleration(at(r)).coordinates() - expected).norm(), 1e-2 * oblate.norm());
}

TEST(GravityField, ItsGradientFollowsTheFrame) {
  struct Body : moving_frame {};
  const auto found = GravityField::egm2008().with_gradient(at({3e6, -5e6, 4e6}));
  const auto R = turned_x(to<Body>, from<Itrf>, 0.3 * si::radian);
  const auto d_itrf = vector<si::length>(in<Itrf>, Vector3d(1.0, -2.0, 0.5));
  const Vector<Body, si::acceleration> change = (R * found.gradient) * (R * d_itrf);
  EXPECT_LE((change.coordinates() - (R * (found.gradient * d_itrf)).coordinates()).norm(), 1e-20);
}

std::string refusal(const std::string& content, int degree) {
  const TemporaryFile file(content);
  const std::string text = complaint([&] { (void)GravityField::read(file.path(), degree); }, file.path()),
                    place = "Gravity field FILE";
  return text.starts_with(place) ? text.substr(place.size()) : text;
}
std::string with(std::string text, const std::string& old, const std::string& other) {
  const auto place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return text.replace(place, old.size(), other);
}

TEST(GravityField, RefusesWrongFilesWithTheLine) {
  const std::string good = Model(3).file();
  EXPECT_EQ(refusal(good, 3), "nothing was thrown");
  EXPECT_EQ(refusal(Model(3).file("d"), 3), "nothing was thrown");
  EXPECT_EQ(refusal(Model(3).file("D"), 3), "nothing was thrown");
  EXPECT_EQ(refusal(good, 4), ", line 7: the model ends at degree 3, 4 is asked for");
  EXPECT_EQ(refusal(good, 1'000'000'000), ", line 7: the model ends at degree 3, 1000000000 is asked for");
  EXPECT_EQ(refusal(good, -1), ": the degree asked for is -1");
  EXPECT_EQ(refusal(with(good, "fully_normalized", "unnormalized"), 3),
            ", line 8: the coefficients are unnormalized");
  EXPECT_EQ(refusal(with(good, "gravity_field", "magnetic_field"), 3),
            ", line 3: the product is a magnetic_field");
  EXPECT_EQ(refusal(with(good, "radius", "rarius"), 3), ", line 9: the head has no radius");
  EXPECT_EQ(refusal(with(good, "earth_gravity_constant 398", "earth_gravity_constant -398"), 3),
            ", line 5: the earth_gravity_constant is -398600441500000, that of the Earth is from "
            "3.98e+14 to 3.99e+14 m^3/s^2");
  EXPECT_EQ(refusal(with(good, "radius ", "radius 6378.1363 or "), 3),
            ", line 6: the radius is 6378.1363, that of the Earth is from 6350000 to 6390000 m");
  EXPECT_EQ(refusal(with(good, "radius ", "radius 6378136.3\nradius "), 3), ", line 7: radius stands twice");
  EXPECT_EQ(refusal(with(good, "product_type", "a product"), 3), ", line 9: the head has no product_type");
  // Not the Earth's: of wrong sign, not normalized, not about the centre of mass.
  for (const char* oblateness : {"4.84165e-4", "-1.0826e-3"}) {
    EXPECT_EQ(refusal(with(good, "gfc 2 0 ", std::string{"gfc 2 0 "} + oblateness + " 0 "), 0).substr(0, 14),
              ", line 13: C o")
        << oblateness;
  }
  EXPECT_EQ(
      refusal(with(good, "gfc 2 0 ", "gfc 2 0 -1.0826e-3 0 "), 3),
      ", line 13: C of degree 2 and order 0 is -0.0010826, that of the Earth, fully normalized, is from "
      "-0.000485 to -0.000483");
  EXPECT_EQ(
      refusal(with(good, "gfc 1 0 ", "gfc 1 0 0.1 0 "), 3),
      ", line 11: the coefficients 0.1 and 0 of degree 1 are more than 1e-08: the origin is not the centre "
      "of mass");
  EXPECT_EQ(refusal(with(good, "gfc 1 1 ", "gfc 1 1 0 -2e-8 "), 3).substr(0, 28),
            ", line 12: the coefficients ");
  EXPECT_EQ(refusal(with(good, "gfc 2 0 ", "gfc 2 0 9e305 0 "), 3),
            ", line 13: the coefficients 9e+305 and 0 of degree 2 are not below 1");
  EXPECT_EQ(refusal(with(good, "end_of_head", "end"), 3), ", line 19: there is no end_of_head");
  EXPECT_EQ(refusal(with(good, "gfc 2 1", "gfct 2 1"), 3),
            ", line 14: 'gfct' is not supported, only gfc: coefficients that do not depend on time");
  EXPECT_EQ(refusal(with(good, "gfc 2 1", "gfc 2 2"), 3), ", line 15: degree 2 and order 2 stand twice");
  EXPECT_EQ(refusal(with(good, "gfc 2 1", "gfc 2 3"), 3), ", line 14: there is no order 3 of degree 2");
  EXPECT_EQ(refusal(with(good, "gfc 3 3", "gfc 4 3"), 3), ", line 19: the degree 4 exceeds max_degree");
  EXPECT_EQ(refusal(good.substr(0, good.find("gfc 3 1")), 3),
            ": the coefficients of degree 3 and order 1 are missing");
  // The last line, "gfc 3 3 C S 0 0", may lack its line end alone.
  const std::string cut = ", line 19: the file stops within this line; it was truncated";
  EXPECT_EQ(refusal(good.substr(0, good.size() - 1), 3), "nothing was thrown");
  EXPECT_EQ(refusal(good.substr(0, good.size() - 3), 3), cut);
  EXPECT_EQ(refusal(good.substr(0, good.size() - 6), 3), cut);
  EXPECT_EQ(refusal(with(good, "gfc 2 0 ", "gfc 2 0 x"), 3).substr(0, 13), ", line 13: 'x");
  EXPECT_EQ(refusal(with(good, "gfc 2 0 ", "gfc 2 0 nan "), 3), ", line 13: 'nan' is not a finite number");
  EXPECT_EQ(refusal("", 3), ": there is no end_of_head");
}

TEST(GravityField, RefusesDegreesAndDepths) {
  EXPECT_EQ(
      complaint([] { (void)GravityField::egm2008(21); }),
      "GravityField::egm2008: the degree is 21; 0 to 20 are built in, read() takes higher ones from a file");
  EXPECT_EQ(
      complaint([] { (void)GravityField::egm2008(-1); }),
      "GravityField::egm2008: the degree is -1; 0 to 20 are built in, read() takes higher ones from a file");
  EXPECT_EQ(complaint([] {
              (void)GravityField::egm2008(4).acceleration(at({0, 0, 6.2e6}));
            }),
            "GravityField: the point is 6200000 m from the centre, inside 0.98 of the radius 6378136.3 m");
  EXPECT_NO_THROW((void)GravityField::egm2008(4).with_gradient(at({0, 0, 6.35e6})));
  EXPECT_NE(
      complaint([] { (void)GravityField::read("/nowhere/at/all.gfc", 2); }).find("all.gfc: cannot be read"),
      std::string::npos);
}

}  // namespace
}  // namespace vectrix::gravity_field_test

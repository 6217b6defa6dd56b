#include <limits>
#include <random>
#include <vector>
#include <vectrix/dynamics/rigid/euler.hpp>

#include "rigid_bodies.hpp"

// Inertia and Euler's equation.
namespace vectrix::test::inertia_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;
constexpr double rounding = 1e-13;  // some tens of operations on numbers of order 1

struct PointMass {
  double mass;
  Vector3d r;
};

std::vector<PointMass> random_body(std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<PointMass> body;
  for (int i = 0; i < 8; ++i)
    body.push_back({1.5 + number(random), {number(random), number(random), number(random)}});
  return body;
}

/// J, h and T by their definitions, as sums over the masses.
Inertia<Body> inertia_of(const std::vector<PointMass>& body) {
  Matrix3d J = Matrix3d::Zero();
  for (const auto& [m, r] : body) J += m * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
  return tensor(J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2));
}

Vector3d random_vector(std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  return {number(random), number(random), number(random)};
}

Inertia<Body> products(double xx, double yy, double zz, double xy, double xz, double yz) {
  const auto unit = si::kilogram_square_metre;
  return inertia_from_moments_and_products(in<Body>, xx * unit, yy * unit, zz * unit, vectrix::xy(xy * unit),
                                           vectrix::xz(xz * unit), vectrix::yz(yz * unit));
}

struct Wheel : moving_frame {};

template <class J, class W>
concept Multiplies = requires(const J& j, const W& w) {
  j* w;
};

// J_b w_ab^b: the rate of the same body b, in the axes of b.
static_assert(Multiplies<Inertia<Body>, BodyRate>);
static_assert(!Multiplies<Inertia<Wheel>, BodyRate>);
static_assert(!Multiplies<Inertia<Body>, AngularVelocity<Gcrf, Body, In<Gcrf>>>);
static_assert(!Multiplies<Inertia<Body>, AngularVelocity<Gcrf, Wheel, In<Body>>>);
static_assert(!Multiplies<Inertia<Body>, Vector<Body, si::angular_velocity>>);

TEST(Inertia, the_doors_differ_by_the_sign_of_the_off_diagonal_numbers) {
  Matrix3d entries;
  entries << 3.0, 0.1, 0.2, 0.1, 4.0, -0.3, 0.2, -0.3, 5.0;
  EXPECT_EQ(tensor(3.0, 4.0, 5.0, 0.1, 0.2, -0.3).matrix(), entries);
  EXPECT_EQ(products(3.0, 4.0, 5.0, -0.1, -0.2, 0.3).matrix(), entries);
}

TEST(Inertia, takes_named_numbers_in_any_order_and_matrices) {
  const auto unit = si::kilogram_square_metre;
  const auto x = 0.1 * unit, y = 0.2 * unit, z = -0.3 * unit, J = 4.0 * unit;
  const Matrix3d expected = tensor(4.0, 4.0, 4.0, 0.1, 0.2, -0.3).matrix();
  EXPECT_EQ(inertia_from_tensor(in<Body>, J, J, J, yz(z), xy(x), xz(y)).matrix(), expected);
  EXPECT_EQ(inertia_from_moments_and_products(in<Body>, J, J, J, xy(-x), yz(-z), zx(-y)).matrix(), expected);
  EXPECT_EQ(inertia_from_tensor(in<Body>, expected).matrix(), expected);
  EXPECT_EQ(inertia_from_tensor(of<Wheel>, about<Body>, in<Body>, expected).matrix(), expected);
  EXPECT_EQ(inertia_from_principal_moments(in<Body>, 3.0 * unit, J, 5.0 * unit).matrix(),
            tensor(3.0, 4.0, 5.0).matrix());
  Matrix3d skewed = expected;
  skewed(0, 2) = 0.3;
  expect_bad_input([&] { inertia_from_tensor(in<Body>, skewed); },
                   "entries (1, 3) and (3, 1) of the tensor differ by 0.0999");
  skewed(0, 2) = std::nan("");
  expect_bad_input([&] { inertia_from_tensor(in<Body>, skewed); },
                   "entry (1, 3) of the tensor is nan kg m^2");
  skewed = expected;
  skewed(2, 2) = std::nan("");
  expect_bad_input([&] { inertia_from_tensor(in<Body>, skewed); },
                   "entry (3, 3) of the tensor is nan kg m^2");
  skewed = expected;
  skewed(2, 1) = -std::numeric_limits<double>::infinity();
  expect_bad_input([&] { inertia_from_tensor(in<Body>, skewed); },
                   "entry (3, 2) of the tensor is -inf kg m^2");
  expect_bad_input([&] { inertia_from_tensor(in<Body>, Eigen::MatrixXd::Identity(3, 2)); },
                   "inertia_from_tensor(in<" + frame_name<Body>() + ">): the matrix has 3 x 2 entries");
  expect_bad_input([&] { inertia_from_principal_moments(in<Body>, 1.0 * unit, 2.0 * unit, 4.0 * unit); },
                   "exceeds the sum of the others by 1");
}

TEST(Inertia, is_the_sum_over_the_masses) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    const auto body = random_body(random);
    Matrix3d sum = Matrix3d::Zero();  // sum of m r_i r_j: second moments
    for (const auto& [m, r] : body) sum += m * r * r.transpose();
    const auto J = products(sum(1, 1) + sum(2, 2), sum(2, 2) + sum(0, 0), sum(0, 0) + sum(1, 1), sum(0, 1),
                            sum(0, 2), sum(1, 2));
    EXPECT_LT((J.matrix() - inertia_of(body).matrix()).norm(), rounding);
    EXPECT_LT((J.inverse_matrix() * J.matrix() - Matrix3d::Identity()).norm(),
              1e3 * rounding);  // times the condition number
  }
}

TEST(Inertia, momentum_and_energy_are_those_of_the_turning_masses) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100; ++i) {
    const auto body = random_body(random);
    const Vector3d w = random_vector(random);
    Vector3d momentum = Vector3d::Zero();
    double energy = 0.0;
    for (const auto& [m, r] : body) {
      momentum += m * r.cross(w.cross(r));
      energy += 0.5 * m * w.cross(r).squaredNorm();
    }
    const Vector<Body, si::angular_momentum> h_b = inertia_of(body) * rate_body(w);
    const Quantity<si::energy> T = kinetic_energy(inertia_of(body), rate_body(w));
    EXPECT_LT((h_b.coordinates() - momentum).norm(), rounding);
    EXPECT_NEAR(T.value(), energy, rounding);
  }
}

TEST(Inertia, results_have_the_units_of_mechanics_and_the_scalar_of_the_operands) {
  using J = Inertia<Body, CentreOfMassOf<Body>, In<Body>, float>;
  using W = AngularVelocity<Gcrf, Body, In<Body>, float>;
  using Torque = Vector<Body, si::torque, float>;
  static_assert(std::same_as<decltype(std::declval<J>() * std::declval<W>()),
                             Vector<Body, si::angular_momentum, float>>);
  static_assert(std::same_as<decltype(kinetic_energy(std::declval<J>(), std::declval<W>())),
                             Quantity<si::energy, float>>);
  static_assert(std::same_as<decltype(euler(std::declval<J>(), std::declval<W>(), std::declval<Torque>())),
                             AngularAcceleration<Gcrf, Body, In<Body>, float>>);
  static_assert(!std::is_default_constructible_v<Inertia<Body>>);
  static_assert(!std::is_constructible_v<Inertia<Body>, Matrix3d>);
}

TEST(Inertia, what_no_body_has_is_refused) {
  const double nan = std::nan("");
  expect_bad_input(
      [&] { tensor(3.0, 4.0, 5.0, 0.0, nan); },
      "inertia_from_tensor(in<" + frame_name<Body>() + ">): entry (1, 3) of the tensor is nan kg m^2");
  expect_bad_input(
      [&] { products(3.0, 4.0, HUGE_VAL, 0.0, 0.0, 0.0); },
      "inertia_from_moments_and_products(in<" + frame_name<Body>() + ">): entry (3, 3) of the tensor is inf");
  expect_bad_input([] { tensor(-3.0, 4.0, 5.0); },
                   "not all principal moments (-3, 4, 5) kg m^2 are positive or zero");
  expect_bad_input([] { tensor(-1e-9, 4.0, 4.0); }, "are positive or zero");
  expect_bad_input([] { tensor(-1.0, -1.0, -1.0); }, "are positive or zero");
  expect_bad_input([] { tensor(0.0, 0.0, 4.0); }, "exceeds the sum of the others by 4");
  expect_bad_input([] { tensor(2.0, 2.0, 2.0, 3.0); }, "are positive or zero");  // moments -1, 2, 5
  expect_bad_input([] { tensor(1.0, 2.0, 4.0); },
                   "the largest principal moment of (1, 2, 4) kg m^2 exceeds the sum of the others by 1");
  expect_bad_input(
      [] { tensor(3.0, 3.0, 3.0, 1.8); },  // moments 1.2, 3, 4.8; the diagonal alone looks like a sphere
      "exceeds the sum of the others by 0.");
}

// 1e-12 of the largest moment, on both sides.
TEST(Inertia, the_tolerances_of_its_moments_hold_on_both_sides) {
  constexpr double bound = 1e-12;
  for (const double size : {1e-20, 1.0, 1e20}) {
    const double J = 4.0 * size;
    EXPECT_NO_THROW(tensor(-0.99 * bound * J, J, J));
    expect_bad_input([&] { tensor(-1.01 * bound * J, J, J); }, "are positive or zero");
    EXPECT_NO_THROW(tensor(J / 4, 3 * J / 4, J * (1 + 0.99 * bound)));  // a plate
    expect_bad_input([&] { tensor(J / 4, 3 * J / 4, J * (1 + 1.01 * bound)); },
                     "exceeds the sum of the others");
    for (const double sign : {-1.0, 1.0}) {
      Matrix3d matrix = J * Matrix3d::Identity();
      matrix(0, 2) = sign * 0.99 * bound * 2 * J;  // of the sum of the two moments
      EXPECT_NO_THROW(inertia_from_tensor(in<Body>, matrix));
      matrix(0, 2) = sign * 1.01 * bound * 2 * J;
      expect_bad_input([&] { inertia_from_tensor(in<Body>, matrix); }, "of the tensor differ by");
    }
  }
}

// They are parts of a body. Euler's equation, which divides by their moments, refuses them.
TEST(Inertia, a_plate_a_rod_and_a_point_are_bodies_however_they_lie) {
  EXPECT_NO_THROW(tensor(1.0, 2.0, 3.0));  // a plate in the xy plane: 1 + 2 = 3
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    const Matrix3d R =
        Eigen::AngleAxisd(pi * random_vector(random).x(), random_vector(random).normalized()).matrix();
    const auto turned = [&](double x, double y, double z) {
      const Matrix3d J = R * Vector3d(x, y, z).asDiagonal() * R.transpose();
      return tensor(J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2));
    };
    for (const double least : {1.0, 1e-3, 1e-6, 1e-9}) {
      const Inertia<Body> J = turned(least, 2.0, least == 1.0 ? 3.0 : 2.0);
      const Eigen::Matrix<long double, 3, 3> exact = J.matrix().cast<long double>().inverse();
      // The inverse of rounded numbers: a rounding grows by the ratio of the moments.
      EXPECT_LE((J.inverse_matrix().cast<long double>() - exact).norm() / exact.norm(),
                4 * std::numeric_limits<double>::epsilon() * 3.0 / least);
    }
    const auto rod = turned(0.0, 2.0, 2.0), point = turned(0.0, 0.0, 0.0);
    for (const Inertia<Body>& part :
         {rod, point, trust_dcm(to<Body>, from<Gcrf>, R) * (trust_dcm(to<Gcrf>, from<Body>, R) * rod)}) {
      EXPECT_FALSE(part.has_inverse());
      expect_bad_input([&] { part.inverse_matrix(); }, "Euler's equation needs the inverse of the inertia [");
      expect_bad_input(
          [&] {
            euler(part, rate_body({1.0, 2.0, 3.0}), zero<si::torque>(in<Body>));
          },
          "kg m^2 in " + frame_name<Body>() + "; a principal moment is zero within rounding");
    }
    expect_bad_input([&] { turned(1.0, 2.0, 3.001); }, "exceeds the sum of the others by 0.00");
  }
}

TEST(Inertia, the_inverse_is_right_at_any_size) {
  for (const double size : {1e-250, 1e-110, 1e110, 1e250}) {
    const auto J = size * si::kilogram_square_metre;
    const auto inertia = inertia_from_principal_moments(in<Body>, 2.0 * J, 2.0 * J, 2.0 * J);
    // The two divisions by the trace each round by half an ulp.
    EXPECT_NEAR(inertia.inverse_matrix()(1, 1) * size, 0.5, 1e-15) << size;
  }
}

TEST(Inertia, the_trusted_door_takes_what_is_no_body) {
  const Matrix3d effective = Vector3d(1.0, 2.0, 4.0).asDiagonal();
  EXPECT_EQ(trust_inertia(in<Body>, effective).matrix(), effective);
  EXPECT_TRUE(trust_inertia(in<Body>, Matrix3d(Vector3d(1e-9, 1e-9, 1.0).asDiagonal())).has_inverse());
}

/// d/dt (R J w) = R tau in the inertial frame, by a central difference along R(t) = R exp(t w + t^2/2 wdot).
TEST(Euler, the_momentum_in_the_inertial_frame_changes_as_the_torque) {
  std::mt19937_64 random(4);
  constexpr double step = 1e-4;  // truncation and rounding of the difference are about 1e-8 and 1e-12
  for (int i = 0; i < 100; ++i) {
    const Inertia<Body> J_b = inertia_of(random_body(random));
    const Vector3d w = random_vector(random);
    const Vector3d torque = 10.0 * random_vector(random);
    const Matrix3d R = Eigen::AngleAxisd(2.0, random_vector(random).normalized()).matrix();
    const Vector3d alpha = euler(J_b, rate_body(w), vector<si::torque>(in<Body>, torque)).coordinates();
    const auto momentum = [&](double t) -> Vector3d {
      const Vector3d turn = t * w + 0.5 * t * t * alpha;
      return R * (Eigen::AngleAxisd(turn.norm(), turn.normalized()) * (J_b.matrix() * (w + t * alpha)));
    };
    const Vector3d rate = (momentum(step) - momentum(-step)) / (2.0 * step);
    EXPECT_LT((rate - R * torque).norm(), 1e-6);
  }
}

TEST(Euler, a_spin_about_a_principal_axis_stays) {
  const Inertia<Body> J_b = tensor(3.0, 4.0, 5.0);
  for (const Vector3d& axis : {Vector3d(0.7, 0.0, 0.0), Vector3d(0.0, -2.0, 0.0), Vector3d(0.0, 0.0, 0.1)}) {
    EXPECT_EQ(euler(J_b, rate_body(axis), torque_body(0.0, 0.0, 0.0)).coordinates(), Vector3d::Zero());
  }
}

/// Euler's equation divides by the moments of inertia.
TEST(Inertia, whose_inverse_is_not_a_number_is_refused_by_eulers_equation) {
  for (const double moment : {1e308, 1e-310}) {
    const auto J_b = tensor(moment, moment, moment);
    expect_bad_input(
        [&] {
          euler(J_b, rate_body({0.0, 0.0, 0.0}), torque_body(1.0, 0.0, 0.0));
        },
        "out of the range of numbers");
  }
}

/// At zero rate, J alpha is the torque.
TEST(Inertia, times_alpha_is_the_torque_at_rest) {
  const auto J = tensor(3.0, 4.0, 5.0);
  const auto torque = torque_body(30.0, 40.0, 50.0);
  const Vector<Body, si::torque> product = J * euler(J, rate_body({0.0, 0.0, 0.0}), torque);
  EXPECT_LT((product.coordinates() - torque.coordinates()).norm(), 50 * rounding);
}

/// wdot = ((b - c) wy wz / a, (c - a) wz wx / b, (a - b) wx wy / c) + (taux/a, tauy/b, tauz/c) for J =
/// diag(a, b, c).
TEST(Euler, the_gyroscopic_term_has_its_sign) {
  const Vector3d alpha =
      euler(tensor(3.0, 4.0, 5.0), rate_body({2.0, 7.0, 11.0}), torque_body(30.0, 40.0, 50.0)).coordinates();
  const Vector3d exact(-77.0 / 3.0 + 10.0, 2.0 * 22.0 / 4.0 + 10.0, -14.0 / 5.0 + 10.0);
  EXPECT_LT((alpha - exact).norm(), rounding);
}

}  // namespace
}  // namespace vectrix::test::inertia_test

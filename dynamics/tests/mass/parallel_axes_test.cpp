#include <sstream>
#include <vectrix/dynamics/mass/join.hpp>

#include "point_masses.hpp"

// A point defined by the user, next to all names of the library.
using namespace vectrix;
namespace {
struct CentreOfMass : named_point {};
}  // namespace
static_assert(Point<CentreOfMass> && !std::same_as<CentreOfMass, CentreOfMassOf<test::Body>>);

// Inertias about other points, in other axes and of several parts, against sums over point masses.
namespace vectrix::test::parallel_axes_test {
namespace {

constexpr double rounding = 1e-12;  // a hundred operations on numbers of order 10
constexpr double visible = 1e-2;    // far above rounding: a wrong formula changes the result by more

TEST(Inertia, law1_change_of_axes_is_the_inertia_of_the_turned_masses) {
  Draw draw(1);
  for (int i = 0; i < 100; ++i) {
    const Masses body = random_masses(draw);
    const Matrix3d R = draw.rotation();
    const auto J_bus = inertia<Body, Hinge, Bus>(body.inertia_about(Vector3d::Zero()));
    const Inertia<Body, Hinge, In<Body>> J_body = trust_dcm(to<Body>, from<Bus>, R) * J_bus;
    EXPECT_LT((J_body.matrix() - body.placed(R, Vector3d::Zero()).inertia_about(Vector3d::Zero())).norm(),
              rounding);
  }
  const Matrix3d J = inertia<Body, Hinge, Bus>(random_masses(draw).inertia_about(Vector3d::Zero())).matrix();
  const Matrix3d R = draw.rotation();
  EXPECT_GT((R * J * R.transpose() - R.transpose() * J * R).norm(), visible);  // else the test proves nothing
}

TEST(Inertia, brought_into_the_body_s_own_axes_it_can_be_divided_by) {
  Draw draw(2);
  const Masses body = random_masses(draw);
  const auto J_bus = inertia<Body, CentreOfMassOf<Body>, Bus>(body.inertia_about(body.centre()));
  const Inertia<Body> J_b = trust_dcm(to<Body>, from<Bus>, draw.rotation()) * J_bus;
  EXPECT_LT((J_b.inverse_matrix() * J_b.matrix() - Matrix3d::Identity()).norm(), 1e3 * rounding);
}

TEST(Inertia, momentum_and_energy_are_the_same_in_all_axes) {
  Draw draw(3);
  const Masses body = random_masses(draw);
  const Inertia<Body> J_b = inertia<Body, CentreOfMassOf<Body>, Body>(body.inertia_about(body.centre()));
  const auto R = trust_dcm(to<Bus>, from<Body>, draw.rotation());
  const BodyRate w_b = rate_body(draw.triple());
  const Vector<Bus, si::angular_momentum> h_bus = (R * J_b) * (R * w_b);
  EXPECT_LT((h_bus.coordinates() - (R * (J_b * w_b)).coordinates()).norm(), rounding);
  EXPECT_NEAR(kinetic_energy(R * J_b, R * w_b).value(), kinetic_energy(J_b, w_b).value(), rounding);
}

TEST(ParallelAxes, to_and_from_the_centre_of_mass) {
  Draw draw(4);
  for (int i = 0; i < 100; ++i) {
    const Masses body = random_masses(draw);
    const Vector3d p = draw.triple();
    const auto J_c = inertia<Body, CentreOfMassOf<Body>, Body>(body.inertia_about(body.centre()));
    const auto r_cp = from_to<CentreOfMassOf<Body>, Hinge, Body>(p - body.centre());
    const Inertia<Body, Hinge> J_p = shift(J_c, r_cp, kilograms(body.total()));
    EXPECT_LT((J_p.matrix() - body.inertia_about(p)).norm(), rounding);
    const Inertia<Body> back = shift(J_p, -r_cp, kilograms(body.total()));
    EXPECT_LT((back.matrix() - J_c.matrix()).norm(), rounding);
  }
}

/// A mass of 2 kg at (1, 2, 3) m: 2 (|r|^2 I - r r^T).
TEST(ParallelAxes, the_term_has_its_sign) {
  const auto J_c = inertia<Body, CentreOfMassOf<Body>, Body>(Vector3d(3.0, 4.0, 5.0).asDiagonal());
  const auto J_p = shift(J_c, from_to<CentreOfMassOf<Body>, Hinge, Body>({1.0, 2.0, 3.0}), kilograms(2.0));
  Matrix3d expected;
  expected << 3.0 + 26.0, -4.0, -6.0, -4.0, 4.0 + 20.0, -12.0, -6.0, -12.0, 5.0 + 10.0;
  EXPECT_EQ(J_p.matrix(), expected);
}

TEST(ParallelAxes, what_no_body_has_about_its_centre_of_mass_is_refused) {
  const auto J_p = inertia<Body, Hinge, Body>(Vector3d(3.0, 4.0, 5.0).asDiagonal());
  const auto r_pc = from_to<Hinge, CentreOfMassOf<Body>, Body>({0.0, 0.0, 1.0});
  expect_bad_input([&] { shift(J_p, r_pc, kilograms(4.0)); },
                   "shift(in<" + frame_name<Body>() + ">): not all principal moments (-1, 0, 5) kg m^2");
  expect_bad_input([&] { shift(J_p, r_pc, kilograms(2.0)); },
                   "the largest principal moment of (1, 2, 5) kg m^2 exceeds the sum of the others by 2");
  EXPECT_NO_THROW(shift(J_p, r_pc, kilograms(0.5)));
}

// The rounding of m r^2 is larger than that of the inertia to which it returns.
TEST(ParallelAxes, a_flat_plate_comes_back_from_far_away) {
  Draw draw(7);
  for (const double distance : {0.2, 20.0, 1e3, 1e5}) {
    for (int i = 0; i < 300; ++i) {
      const double m = 0.2 * std::pow(100.0, (draw.triple().x() + 1) / 2);
      const Vector3d size = draw.triple().cwiseAbs() + Vector3d::Constant(0.1);
      const double x = m * size.x() * size.x() / 12, y = m * size.y() * size.y() / 12;
      const Matrix3d R = draw.rotation();
      const auto J_c =
          inertia<Body, CentreOfMassOf<Body>, Body>(R * Vector3d(x, y, x + y).asDiagonal() * R.transpose());
      const Vector3d away = distance * draw.triple().normalized();
      const auto J_p = shift(J_c, from_to<CentreOfMassOf<Body>, Hinge, Body>(away), kilograms(m));
      const Inertia<Body> back = shift(J_p, from_to<Hinge, CentreOfMassOf<Body>, Body>(-away), kilograms(m));
      EXPECT_LE((back.matrix() - J_c.matrix()).norm(),
                16 * std::numeric_limits<double>::epsilon() * J_p.matrix().trace());
    }
  }
}

// A mass of 1 kg at 1 m has the trace 2 kg m^2. Each entry is a sum of some five products, there and back:
// the sum of the moments may be short by ten roundings of the trace, not by a hundred.
TEST(ParallelAxes, what_is_allowed_for_rounding_is_a_few_of_the_larger) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const auto back = [](double missing) {
    const auto J_p = inertia<Body, Hinge, Body>(Vector3d(0.0, 1.0 - missing, 1.0 - missing).asDiagonal());
    return shift(J_p, from_to<Hinge, CentreOfMassOf<Body>, Body>({1.0, 0.0, 0.0}), kilograms(1.0));
  };
  const double rounding_of_trace = 2 * epsilon;  // two moments lack it
  EXPECT_NO_THROW(back(10 * rounding_of_trace / 2));
  expect_bad_input([&] { back(100 * rounding_of_trace / 2); }, "not all principal moments");
}

// What is left of a rod is rounding, which is no moment to divide by.
TEST(ParallelAxes, a_rod_comes_back_as_a_rod) {
  Draw draw(8);
  for (const double distance : {0.2, 20.0, 1e3}) {
    for (int i = 0; i < 300; ++i) {
      const Matrix3d R = draw.rotation();
      const auto J_c =
          inertia<Body, CentreOfMassOf<Body>, Body>(R * Vector3d(0.0, 0.1, 0.1).asDiagonal() * R.transpose());
      const Vector3d away = distance * draw.triple().normalized();
      const auto J_p = shift(J_c, from_to<CentreOfMassOf<Body>, Hinge, Body>(away), kilograms(1.0));
      const Inertia<Body> back =
          shift(J_p, from_to<Hinge, CentreOfMassOf<Body>, Body>(-away), kilograms(1.0));
      EXPECT_FALSE(back.has_inverse());
    }
  }
}

TEST(ParallelAxes, an_inertia_that_overflows_is_refused) {
  const auto J_c = inertia<Body, CentreOfMassOf<Body>, Body>(Vector3d(3.0, 4.0, 5.0).asDiagonal());
  const auto r_cp = from_to<CentreOfMassOf<Body>, Hinge, Body>({1e200, 0.0, 0.0});
  expect_bad_input([&] { shift(J_c, r_cp, kilograms(1.0)); },
                   "shift(" + frame_name<Body>() + "): the inertia overflows at a distance of 1e+200 m");
}

TEST(ParallelAxes, a_mass_is_positive) {
  const auto J_c = inertia<Body, CentreOfMassOf<Body>, Body>(Vector3d(3.0, 4.0, 5.0).asDiagonal());
  const auto r_cp = from_to<CentreOfMassOf<Body>, Hinge, Body>({0.1, 0.2, 0.3});
  const auto J_p = shift(J_c, r_cp, kilograms(1.0));
  for (const double m : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    const std::string said = "(" + frame_name<Body>() + "): the mass is " + detail::text(m) + " kg";
    expect_bad_input([&] { shift(J_c, r_cp, kilograms(m)); }, "shift" + said);
    expect_bad_input([&] { shift(J_p, -r_cp, kilograms(m)); }, "shift" + said);
  }
}

TEST(Inertia, a_door_about_another_point_names_all_three) {
  expect_bad_input([] { inertia<Bus, Hinge, Body>(Vector3d(1.0, 2.0, 4.0).asDiagonal()); },
                   "inertia_from_tensor(of<" + frame_name<Bus>() + ">, about<" + frame_name<Hinge>() +
                       ">, in<" + frame_name<Body>() +
                       ">): the largest principal moment of (1, 2, 4) kg m^2 exceeds");
  const auto unit = si::kilogram_square_metre;
  const Inertia<Bus, Hinge, In<Body>> J =
      inertia_from_moments_and_products(of<Bus>, about<Hinge>, in<Body>, 3.0 * unit, 4.0 * unit, 5.0 * unit,
                                        yz(-0.3 * unit), xy(0.1 * unit), zx(0.2 * unit));
  EXPECT_EQ(J.matrix(), tensor(3.0, 4.0, 5.0, -0.1, -0.2, 0.3).matrix());
}

TEST(Join, parts_about_one_point_add) {
  Draw draw(5);
  for (int i = 0; i < 100; ++i) {
    const Masses bus = random_masses(draw), panel_1 = random_masses(draw), panel_2 = random_masses(draw);
    const Vector3d p = draw.triple();
    const Inertia<Satellite, Hinge, In<Bus>> J =
        join(of<Satellite>, inertia<Bus, Hinge, Bus>(bus.inertia_about(p)),
             inertia<Panel<1>, Hinge, Bus>(panel_1.inertia_about(p)),
             inertia<Panel<2>, Hinge, Bus>(panel_2.inertia_about(p)));
    Masses all = bus;
    all.add(panel_1);
    all.add(panel_2);
    EXPECT_LT((J.matrix() - all.inertia_about(p)).norm(), rounding);
  }
}

template <class T> std::string printed(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

TEST(Print, an_inertia_says_its_unit_body_point_and_frame) {
  const std::string entries = "[3 0 0; 0 4 0; 0 0 5] kg m^2", body = frame_name<Body>();
  const Matrix3d J = Vector3d(3.0, 4.0, 5.0).asDiagonal();
  EXPECT_EQ(printed(inertia<Body, CentreOfMassOf<Body>, Body>(J)), entries + " in " + body);
  EXPECT_EQ(printed(inertia<Body, Hinge, Bus>(J)),
            entries + " of " + body + " about " + frame_name<Hinge>() + " in " + frame_name<Bus>());
}

template <class... Given>
concept Shifts = requires(const Given&... given) {
  shift(given...);
};
template <class Whole, class... Parts>
concept Joins = requires(const Parts&... parts) {
  join(of<Whole>, parts...);
};
template <class Left, class Right>
concept Adds = requires(const Left& left, const Right& right) {
  left + right;
};
template <class T>
concept Negates = requires(const T& value) {
  -value;
};
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};

using Mass = Quantity<si::mass>;
using FromHinge = Displacement<Hinge, CentreOfMassOf<Body>, In<Body>>;
using ToHinge = Displacement<CentreOfMassOf<Body>, Hinge, In<Body>>;
static_assert(std::same_as<Inertia<Body>, Inertia<Body, CentreOfMassOf<Body>, In<Body>, double>>);
static_assert(Shifts<Inertia<Body>, ToHinge, Mass> && Shifts<Inertia<Body, Hinge>, FromHinge, Mass>);
static_assert(!Shifts<Inertia<Body>, FromHinge, Mass> && !Shifts<Inertia<Body, Hinge>, ToHinge, Mass>);
static_assert(!Shifts<Inertia<Bus>, ToHinge, Mass>);
static_assert(!Shifts<Inertia<Body>, ToHinge>);
static_assert(!Shifts<Inertia<Body, CentreOfMassOf<Body>, In<Bus>>, ToHinge, Mass>);
// The shift must start or end at the centre of mass.
static_assert(!Shifts<Inertia<Body, Hinge>, Displacement<Hinge, Bus, In<Body>>, Mass>);
static_assert(Multiplies<Dcm<Bus, Body>, Inertia<Body>>);
static_assert(!Multiplies<Dcm<Body, Bus>, Inertia<Body>>);
static_assert(!Multiplies<Inertia<Body>, Dcm<Body, Bus>>);
static_assert(!Multiplies<Inertia<Body, Hinge>, BodyRate>);
static_assert(!Adds<Inertia<Body>, Inertia<Body>>);
static_assert(!Negates<Inertia<Body>> && !Negates<Inertia<Body, Hinge>>);
static_assert(Joins<Satellite, Inertia<Bus, Hinge, In<Body>>, Inertia<Body, Hinge>>);
static_assert(!Joins<Satellite, Inertia<Bus>, Inertia<Body>>);
static_assert(!Joins<Satellite, Inertia<Bus, Hinge>, Inertia<Body, Hinge>>);
static_assert(!Joins<Satellite, Inertia<Body, Hinge>, Inertia<Body, Hinge>>);
static_assert(!Joins<Body, Inertia<Bus, Hinge, In<Body>>, Inertia<Body, Hinge>>);
static_assert(!std::is_default_constructible_v<Inertia<Body, Hinge>>);
static_assert(sizeof(Inertia<Body, Hinge>) == sizeof(Matrix3d));

}  // namespace
}  // namespace vectrix::test::parallel_axes_test

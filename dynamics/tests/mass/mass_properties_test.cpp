#include <sstream>
#include <vectrix/dynamics/mass/mass_properties.hpp>

#include "point_masses.hpp"

// Mass, centre of mass and inertia of bodies and of joined bodies, against sums over point masses.
namespace vectrix::test::mass_properties_test {
namespace {

constexpr double rounding = 1e-12;  // a hundred operations on numbers of order 10

/// The mass properties of these masses, as a body B in its own axes.
template <class B> MassProperties<B> properties(const Masses& body) {
  return mass_properties(kilograms(body.total()), from_to<B, CentreOfMassOf<B>, B>(body.centre()),
                         inertia<B, CentreOfMassOf<B>, B>(body.inertia_about(body.centre())));
}

/// A panel, given in its own frame and mounted on a bus: its masses are rotated and moved.
TEST(MassProperties, laws_1_2_3_a_satellite_of_parts_is_that_of_all_their_masses) {
  Draw draw(6);
  for (int i = 0; i < 100; ++i) {
    const Masses bus = random_masses(draw), panel_1 = random_masses(draw), panel_2 = random_masses(draw);
    const Matrix3d R_1 = draw.rotation(), R_2 = draw.rotation();
    const Vector3d r_1 = draw.triple(), r_2 = draw.triple();
    const MassProperties<Satellite, Bus, In<Bus>> satellite =
        join(of<Satellite>, properties<Bus>(bus),
             shift(trust_dcm(to<Bus>, from<Panel<1>>, R_1) * properties<Panel<1>>(panel_1),
                   from_to<Panel<1>, Bus, Bus>(-r_1)),
             shift(trust_dcm(to<Bus>, from<Panel<2>>, R_2) * properties<Panel<2>>(panel_2),
                   from_to<Panel<2>, Bus, Bus>(-r_2)));
    Masses all = bus;
    all.add(panel_1.placed(R_1, r_1));
    all.add(panel_2.placed(R_2, r_2));
    EXPECT_NEAR(satellite.mass().value(), all.total(), rounding);
    EXPECT_LT((satellite.centre().coordinates() - all.centre()).norm(), rounding);
    EXPECT_LT((satellite.inertia().matrix() - all.inertia_about(all.centre())).norm(), rounding);
    const Inertia<Satellite, Bus, In<Bus>> J_bus =
        shift(satellite.inertia(), -satellite.centre(), satellite.mass());
    EXPECT_LT((J_bus.matrix() - all.inertia_about(Vector3d::Zero())).norm(), rounding);
  }
}

// A boom is a rod along its x axis, its tip a point: no moments about the axis, none at all.
TEST(MassProperties, a_rod_and_a_point_are_parts) {
  struct Boom : moving_frame {};
  struct Tip : moving_frame {};
  Draw draw(9);
  const double length = 4.0, m_boom = 1.5, m_tip = 0.5;
  const Masses bus = random_masses(draw);
  const Vector3d none = Vector3d::Zero(), half(length / 2, 0.0, 0.0), end(length, 0.0, 0.0);
  const double J_rod = m_boom * length * length / 12;
  const auto boom =
      mass_properties(kilograms(m_boom), from_to<Boom, CentreOfMassOf<Boom>, Boom>(half),
                      inertia<Boom, CentreOfMassOf<Boom>, Boom>(Vector3d(0.0, J_rod, J_rod).asDiagonal()));
  const auto tip = mass_properties(kilograms(m_tip), from_to<Tip, CentreOfMassOf<Tip>, Tip>(none),
                                   inertia<Tip, CentreOfMassOf<Tip>, Tip>(Matrix3d::Zero()));
  const Matrix3d R = draw.rotation();
  const Vector3d hinge = draw.triple();
  const auto R_bus_from_boom = trust_dcm(to<Bus>, from<Boom>, R);
  const auto R_bus_from_tip = trust_dcm(to<Bus>, from<Tip>, R);
  const MassProperties<Satellite, Bus, In<Bus>> satellite = join(
      of<Satellite>, properties<Bus>(bus), shift(R_bus_from_boom * boom, from_to<Boom, Bus, Bus>(-hinge)),
      shift(R_bus_from_tip * tip, from_to<Tip, Bus, Bus>(-(hinge + R * end))));
  // A rod has the mass, the centre and the inertia of a sixth of its mass at each end and the rest at its
  // centre.
  Masses all = bus;
  Masses line;
  line.m = {m_boom / 6, m_boom * 2 / 3, m_boom / 6 + m_tip};
  line.r = {none, half, end};
  all.add(line.placed(R, hinge));
  EXPECT_LT((satellite.centre().coordinates() - all.centre()).norm(), rounding);
  EXPECT_LT((satellite.inertia().matrix() - all.inertia_about(all.centre())).norm(), rounding);
}

TEST(MassProperties, say_the_mass_the_centre_and_the_inertia) {
  const auto r_bc = from_to<Body, CentreOfMassOf<Body>, Body>({1.0, 2.0, 3.0});
  const auto J_c = inertia<Body, CentreOfMassOf<Body>, Body>(Vector3d(3.0, 4.0, 5.0).asDiagonal());
  std::ostringstream said, parts;
  said << mass_properties(kilograms(2.0), r_bc, J_c);
  parts << "2 kg; " << r_bc << "; " << J_c;
  EXPECT_EQ(said.str(), parts.str());
}

TEST(MassProperties, have_a_positive_mass) {
  const auto r_bc = from_to<Body, CentreOfMassOf<Body>, Body>({0.1, 0.2, 0.3});
  const auto J_c = inertia<Body, CentreOfMassOf<Body>, Body>(Vector3d(3.0, 4.0, 5.0).asDiagonal());
  for (const double m : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    expect_bad_input([&] { mass_properties(kilograms(m), r_bc, J_c); },
                     "mass_properties(" + frame_name<Body>() + "): the mass is " + detail::text(m) + " kg");
  }
}

template <class... Given>
concept Shifts = requires(const Given&... given) {
  shift(given...);
};
template <class Whole, class... Parts>
concept Joins = requires(const Parts&... parts) {
  join(of<Whole>, parts...);
};
template <class T>
concept Negates = requires(const T& value) {
  -value;
};
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};

static_assert(Shifts<MassProperties<Body>, Displacement<Body, Hinge, In<Body>>>);
static_assert(!Shifts<MassProperties<Body>, Displacement<Hinge, Body, In<Body>>>);
static_assert(!Shifts<MassProperties<Body>, Displacement<Body, Hinge, In<Bus>>>);
static_assert(Multiplies<Dcm<Bus, Body>, MassProperties<Body>> &&
              !Multiplies<Dcm<Body, Bus>, MassProperties<Body>>);
static_assert(Joins<Satellite, MassProperties<Bus>, MassProperties<Body, Bus, In<Bus>>>);
static_assert(!Joins<Satellite, MassProperties<Bus>, MassProperties<Body>>);
static_assert(!Joins<Satellite, MassProperties<Bus>, MassProperties<Bus>>);
static_assert(!Negates<MassProperties<Body>> && !std::is_default_constructible_v<MassProperties<Body>>);

}  // namespace
}  // namespace vectrix::test::mass_properties_test

#include <gtest/gtest.h>

#include <string>
#include <vectrix/kinematics.hpp>

#include "../../../frames/tests/attitudes.hpp"

// With VECTRIX_CHECK_INSTANTS: what a graph answers at one instant does not go with what it answers at
// another.
using namespace vectrix;
using namespace vectrix_test;

namespace {

const auto second = Quantity<si::time>::from_value(1.0);
const auto early = Quantity<si::time>::from_value(1.0);
const auto late = Quantity<si::time>::from_value(1.5);

const auto axis_b = vector<si::length>(in<Body>, Eigen::Vector3d(0.2, -1.0, 3.0));

AcceleratingTransform<Gcrf, Body> tumbling(double t) {
  const auto angle = Quantity<si::angle>::from_value(0.3 * t);
  return {
      accelerating_dcm(
          turned_z(to<Gcrf>, from<Body>, angle),
          angular_velocity(of<Body>, relative_to<Gcrf>,
                           vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(0.0, 0.1 * t, -0.3))),
          angular_acceleration(of<Body>, relative_to<Gcrf>,
                               vector<si::angular_acceleration>(in<Body>, Eigen::Vector3d(0.0, 0.1, 0.0)))),
      displacement(of<Body>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, Eigen::Vector3d(t, 2.0, 3.0))),
      velocity(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>,
               vector<si::velocity>(in<Gcrf>, Eigen::Vector3d(1.0, 0.0, 0.0))),
      unaccelerated(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>)};
}

// gcrf - body - camera, and gcrf - wheel 1; the camera is mounted rigidly.
const auto graph =
    frame_graph(edge([](Quantity<si::time> t) { return tumbling(t.value()); }),
                rigid_edge(Transform{turned_x(to<Body>, from<Camera>, Quantity<si::angle>::from_value(0.4)),
                                     displacement(of<Camera>, relative_to<Body>, axis_b)}),
                edge([](Quantity<si::time> t) {
                  return turned_y(to<Gcrf>, from<Wheel<1>>, Quantity<si::angle>::from_value(t.value()));
                }));

const auto at_early = graph.at(early);
const auto at_late = graph.at(late);

template <class Snapshot> auto R_i_from_b(const Snapshot& now) {
  return now.rotation(to<Gcrf>, from<Body>);
}
template <class Snapshot> auto R_b_from_i(const Snapshot& now) {
  return now.rotation(to<Body>, from<Gcrf>);
}
template <class Snapshot> auto w_ib_b(const Snapshot& now) {
  return now.angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>);
}
template <class Snapshot> auto alpha_ib_b(const Snapshot& now) {
  return now.angular_acceleration(of<Body>, relative_to<Gcrf>, in<Body>);
}
template <class Snapshot> auto r_ic_b(const Snapshot& now) {
  return now.position(of<Camera>, relative_to<Gcrf>, in<Body>);
}
template <class Snapshot> auto v_ic_b(const Snapshot& now) {
  return now.velocity(of<Camera>, relative_to<Gcrf>, observed_from<Body>, in<Body>);
}
template <class Snapshot> auto a_ic_b(const Snapshot& now) {
  return now.acceleration(of<Camera>, relative_to<Gcrf>, observed_from<Body>, in<Body>);
}
template <class Snapshot> auto X_i_from_b(const Snapshot& now) {
  return now.transform(to<Gcrf>, from<Body>);
}

/// f(one instant, another) is refused, and f of one instant is not.
template <class F> void expect_refused(const F& f) {
  EXPECT_THROW(f(at_early, at_late), TwoInstants);
  EXPECT_THROW(f(at_late, at_early), TwoInstants);
  EXPECT_NO_THROW(f(at_early, at_early));
  EXPECT_NO_THROW(f(at_early, graph.at(early)));
}

TEST(Instants, OfRotationsAreNotMixed) {
  expect_refused([](const auto& s, const auto& t) { return Dcm<Gcrf, Gcrf>{R_i_from_b(s) * R_b_from_i(t)}; });
  expect_refused(
      [](const auto& s, const auto& t) { return Dcm<Gcrf, Gcrf>{R_i_from_b(s) * inverse(R_i_from_b(t))}; });
  expect_refused([](const auto& s, const auto& t) {
    return quaternion(R_i_from_b(s)) * inverse(quaternion(R_i_from_b(t)));
  });
  expect_refused(
      [](const auto& s, const auto& t) { return dcm(quaternion(R_i_from_b(s))) * exp(log(R_b_from_i(t))); });
  expect_refused([](const auto& s, const auto& t) { return X_i_from_b(s) * inverse(X_i_from_b(t)); });
}

TEST(Instants, OfAChainAreNotMixed) {
  const auto R_c_from_b = turned_x(to<Camera>, from<Body>, Quantity<si::angle>::from_value(0.4));
  expect_refused(
      [&](const auto& s, const auto& t) { return R_c_from_b * R_b_from_i(s) * R_i_from_b(t) * axis_b; });
  expect_refused([&](const auto& s, const auto& t) {
    const auto R_c_from_i = R_c_from_b * R_b_from_i(s);
    return R_c_from_i * (R_i_from_b(t) * axis_b);
  });
  expect_refused([&](const auto& s, const auto& t) {
    const Dcm<Camera, Gcrf> R_c_from_i = R_c_from_b * R_b_from_i(s);
    return R_c_from_i * (R_i_from_b(t) * axis_b);
  });
}

TEST(Instants, OfRatesAreNotMixed) {
  expect_refused([](const auto& s, const auto& t) { return w_ib_b(s) + -w_ib_b(t); });
  expect_refused([](const auto& s, const auto& t) { return R_i_from_b(s) * w_ib_b(t); });
  expect_refused([](const auto& s, const auto& t) { return R_i_from_b(s) * alpha_ib_b(t); });
  expect_refused([](const auto& s, const auto& t) { return rate(R_i_from_b(s), w_ib_b(t)); });
  expect_refused([](const auto& s, const auto& t) { return moving_dcm(R_i_from_b(s), w_ib_b(t)); });
  expect_refused(
      [](const auto& s, const auto& t) { return accelerating_dcm(R_i_from_b(s), w_ib_b(s), alpha_ib_b(t)); });
  expect_refused([](const auto& s, const auto& t) {
    return inverse(moving_dcm(R_i_from_b(s), w_ib_b(s))) * moving_dcm(R_i_from_b(t), w_ib_b(t));
  });
  expect_refused([](const auto& s, const auto& t) {
    return chain(-alpha_ib_b(s), alpha_ib_b(s), -w_ib_b(s), w_ib_b(t));
  });
  expect_refused([](const auto& s, const auto& t) {
    const auto w_ib_i = angular_velocity(R_i_from_b(s), rate(R_i_from_b(s), w_ib_b(s)), in<Gcrf>);
    return R_b_from_i(t) * w_ib_i;
  });
}

TEST(Instants, OfPlacesAndVelocitiesAreNotMixed) {
  expect_refused([](const auto& s, const auto& t) { return r_ic_b(s) + -r_ic_b(t); });
  expect_refused([](const auto& s, const auto& t) { return v_ic_b(s) + -v_ic_b(t); });
  expect_refused([](const auto& s, const auto& t) { return a_ic_b(s) + -a_ic_b(t); });
  expect_refused(
      [](const auto& s, const auto& t) { return inverse(X_i_from_b(s)) * (R_i_from_b(t) * r_ic_b(t)); });
  expect_refused([](const auto& s, const auto& t) {
    return transport(observed_from<Gcrf>, v_ic_b(s), r_ic_b(s), w_ib_b(t));
  });
  expect_refused([](const auto& s, const auto& t) {
    return transport(observed_from<Gcrf>, a_ic_b(s), v_ic_b(s), r_ic_b(t), alpha_ib_b(s), w_ib_b(s));
  });
  expect_refused([](const auto& s, const auto& t) { return euler_acceleration(alpha_ib_b(s), r_ic_b(t)); });
  expect_refused([](const auto& s, const auto& t) { return coriolis_acceleration(w_ib_b(s), v_ic_b(t)); });
  expect_refused([](const auto& s, const auto& t) { return centrifugal_acceleration(w_ib_b(s), r_ic_b(t)); });
}

TEST(Instants, StayWithTheResultsOfProducts) {
  const auto r_i = [](const auto& now) { return R_i_from_b(now) * axis_b; };
  expect_refused([&](const auto& s, const auto& t) { return r_i(s) + r_i(t); });
  expect_refused([&](const auto& s, const auto& t) { return r_i(s) - 2.0 * r_i(t); });
  expect_refused([&](const auto& s, const auto& t) { return dot(r_i(s), r_i(t) / second); });
  expect_refused([&](const auto& s, const auto& t) { return cross(r_i(s), -r_i(t)); });
  expect_refused([&](const auto& s, const auto& t) { return cross(w_ib_b(s), r_ic_b(t).vector()); });
  expect_refused([&](const auto& s, const auto& t) { return direction(r_i(s)) + direction(r_i(t)); });
  expect_refused([&](const auto& s, const auto& t) { return rotate(R_i_from_b(s), r_i(t)); });
  expect_refused([&](const auto& s, const auto& t) {
    auto sum_i = r_i(s);
    sum_i += r_i(t);
    return sum_i;
  });
  expect_refused([&](const auto& s, const auto& t) {
    const auto V = [](const auto& now) { return twist(at<Camera>, w_ib_b(now), cross(w_ib_b(now), axis_b)); };
    return V(s) + -V(t);
  });
}

TEST(Instants, OfAnAssignedQuantityAreTheNewOnes) {
  auto R = R_i_from_b(at_early);
  R = R_i_from_b(at_late);
  EXPECT_NO_THROW(R * w_ib_b(at_late));
  EXPECT_THROW(R * w_ib_b(at_early), TwoInstants);
}

TEST(Instants, NoneHaveConstantsAndWhatComesThroughADoor) {
  const auto R_b_from_c = at_early.rotation(to<Body>, from<Camera>);
  EXPECT_NO_THROW(R_i_from_b(at_late) * R_b_from_c);
  EXPECT_NO_THROW(at_late.rotation(to<Gcrf>, from<Gcrf>) * R_i_from_b(at_early));
  EXPECT_NO_THROW(w_ib_b(at_late) + at_early.angular_velocity(of<Camera>, relative_to<Body>, in<Body>));
  EXPECT_NO_THROW(r_ic_b(at_late) + at_early.position(of<Body>, relative_to<Camera>, in<Body>));
  EXPECT_NO_THROW(R_i_from_b(at_late) * axis_b);
  EXPECT_NO_THROW(R_i_from_b(at_late) * vector<si::length>(in<Body>, r_ic_b(at_early).coordinates()));
}

TEST(Instants, OfWhatAnEdgeCarriesAreThoseOfItsGraph) {
  // A constant edge claims that its value holds always, and a function that its value is of the time it was
  // asked for: as the body was seen half a second after it was so.
  const auto frozen = frame_graph(static_edge(R_i_from_b(at_early)));
  EXPECT_NO_THROW(frozen.at(late).rotation(to<Body>, from<Gcrf>) * (R_i_from_b(at_late) * axis_b));
  const auto seen =
      frame_graph(edge([](Quantity<si::time> t) { return R_i_from_b(graph.at(t - 0.5 * second)); }),
                  edge([](Quantity<si::time>) {
                    return Dcm<Body, Camera>{R_b_from_i(at_early) * aligned(to<Gcrf>, from<Camera>)};
                  }));
  const auto R_i_from_c = seen.at(late).rotation(to<Gcrf>, from<Camera>);
  EXPECT_NO_THROW(inverse(R_i_from_c) * R_i_from_b(at_late));
  EXPECT_THROW(inverse(R_i_from_c) * R_i_from_b(at_early), TwoInstants);
}

struct Counted {
  int number;
  bool operator==(const Counted&) const = default;
};
struct Uncompared {
  double t;
};

TEST(Instants, AreOfAnyTypeThatCanBeCompared) {
  const auto turn = [](auto t, const auto& number) {
    return frame_graph(edge([number](decltype(t) instant) {
      return turned_z(to<Gcrf>, from<Body>, Quantity<si::angle>::from_value(number(instant)));
    }));
  };
  const auto mixed = [](const auto& turns, const auto& s, const auto& t) {
    return R_b_from_i(turns.at(s)) * (R_i_from_b(turns.at(t)) * axis_b);
  };
  const auto by_number = turn(0.0, [](double t) { return t; });
  const auto by_count = turn(Counted{}, [](Counted count) { return 0.1 * count.number; });
  const auto by_state = turn(Uncompared{}, [](Uncompared state) { return state.t; });
  EXPECT_NO_THROW(mixed(by_number, 1.0, 1.0));
  EXPECT_THROW(mixed(by_number, 1.0, 2.0), TwoInstants);
  EXPECT_NO_THROW(mixed(by_count, Counted{1}, Counted{1}));
  EXPECT_THROW(mixed(by_count, Counted{1}, Counted{2}), TwoInstants);
  // Instants of two types, or without ==, say nothing.
  EXPECT_NO_THROW(mixed(by_state, Uncompared{1.0}, Uncompared{2.0}));
  EXPECT_NO_THROW(R_b_from_i(by_number.at(3.0)) * R_i_from_b(at_early));
}

TEST(Instants, MayBeDroppedByName) {
  const auto difference_i =
      without_instant(R_i_from_b(at_late)) * axis_b - without_instant(R_i_from_b(at_early)) * axis_b;
  EXPECT_GT(norm(difference_i).value(), 0.1);
  EXPECT_NO_THROW(without_instant(w_ib_b(at_late)) + -w_ib_b(at_early));
  EXPECT_NO_THROW(without_instant(R_i_from_b(at_late) * aligned(to<Body>, from<Camera>)) *
                  at_early.rotation(to<Camera>, from<Gcrf>));
  EXPECT_NO_THROW(without_instant(X_i_from_b(at_late)) * inverse(X_i_from_b(at_early)));
}

TEST(Instants, AreNamedWhenTwoMeet) {
  try {
    static_cast<void>(R_i_from_b(at_early) * w_ib_b(at_late));
    FAIL() << "two instants were combined";
  } catch (const TwoInstants& error) {
    const std::string text = error.what();
    for (const char* part :
         {"product: ", "Dcm<", "AngularVelocity<", "Gcrf", "Body", "> at 1 s", "> at 1.5 s"}) {
      EXPECT_NE(text.find(part), text.npos) << part << " in: " << text;
    }
  }
}

}  // namespace

#include <gtest/gtest.h>

#include <vectrix/kinematics/named_graph.hpp>
#include <vectrix/kinematics/named_quaternion.hpp>

#include "../../../frames/tests/attitudes.hpp"

// With VECTRIX_CHECK_INSTANTS: the same of frames known at run time.
using namespace vectrix;
using namespace vectrix_test;

namespace {

const auto early = Quantity<si::time>::from_value(1.0);
const auto late = Quantity<si::time>::from_value(1.5);

/// Gcrf and Body, bound to types, and a camera mounted rigidly on the body.
class NamedInstants : public testing::Test {
 protected:
  NamedGraph graph;
  NamedFrame i = graph.add_frame<Gcrf>("gcrf");
  NamedFrame b = graph.add_frame<Body>("body");
  NamedFrame c = graph.add_frame("camera", FrameMotion::moving);

  NamedInstants() {
    graph.add_edge(edge([](Quantity<si::time> t) {
      return moving_dcm(
          turned_z(to<Gcrf>, from<Body>, Quantity<si::angle>::from_value(0.3 * t.value())),
          angular_velocity(of<Body>, relative_to<Gcrf>,
                           vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(0.0, 0.0, 0.3))));
    }));
    graph.add_edge(rigid_edge(aligned(To(b), From(c))));
  }

  /// f(one instant, another) is refused, and f of one instant is not.
  template <class F> void expect_refused(const F& f) {
    EXPECT_THROW(f(graph.at(early), graph.at(late)), TwoInstants);
    EXPECT_NO_THROW(f(graph.at(early), graph.at(early)));
  }
};

TEST_F(NamedInstants, OfTypedAnswersAreNotMixed) {
  expect_refused([](const auto& s, const auto& t) {
    return s.rotation(to<Gcrf>, from<Body>) * t.angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>);
  });
}

TEST_F(NamedInstants, OfNamedAnswersAreNotMixed) {
  const auto r_b = vector<si::length>(In(b), Eigen::Vector3d(0.2, -1.0, 3.0));
  expect_refused([&](const auto& s, const auto& t) {
    return s.rotation(To(c), From(i)) * inverse(t.rotation(To(c), From(i)));
  });
  expect_refused([&](const auto& s, const auto& t) {
    return dcm(quaternion(s.rotation(To(c), From(i)))) * t.rotation(To(i), From(b));
  });
  expect_refused([&](const auto& s, const auto& t) {
    return s.rotation(To(i), From(b)) * r_b - t.rotation(To(i), From(b)) * r_b;
  });
  expect_refused([&](const auto& s, const auto& t) {
    return s.angular_velocity(Of(b), RelativeTo(i), In(b)) + -t.angular_velocity(Of(b), RelativeTo(i), In(b));
  });
  expect_refused([&](const auto& s, const auto& t) {
    return moving_dcm(s.rotation(To(i), From(b)), t.angular_velocity(Of(b), RelativeTo(i), In(b)));
  });
  expect_refused([&](const auto& s, const auto& t) {
    return graph.typed(to<Gcrf>, from<Body>, s.rotation(To(i), From(b))) * t.rotation(to<Body>, from<Gcrf>);
  });
}

TEST_F(NamedInstants, NoneHaveConstants) {
  const auto at_late = graph.at(late);
  EXPECT_NO_THROW(at_late.rotation(To(i), From(b)) * graph.at(early).rotation(To(b), From(c)));
  EXPECT_NO_THROW(at_late.angular_velocity(Of(b), RelativeTo(i), In(b)) +
                  graph.at(early).angular_velocity(Of(c), RelativeTo(b), In(b)));
  EXPECT_NO_THROW(without_instant(at_late.rotation(To(i), From(b))) *
                  graph.at(early).rotation(To(b), From(i)));
}

}  // namespace

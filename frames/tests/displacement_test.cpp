#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/displacement.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace displacement_test {
namespace {

struct CentreOfMass : named_point {};
template <int I> struct Thruster : named_point {};

template <class P, class Q, class C> Displacement<P, Q, In<C>> any_displacement() {
  return displacement(of<Q>, relative_to<P>, vector<si::length>(in<C>, *triple()));
}

// 1. r_pq^c + r_qs^c = r_ps^c, in either order; r_pq^c + r_qp^c = 0.
RC_GTEST_PROP(Displacement, Law1SumsChain, ()) {
  const auto r_pq = any_displacement<Body, CentreOfMass, Camera>();
  const auto r_qs = any_displacement<CentreOfMass, Thruster<1>, Camera>();
  const Displacement<Body, Thruster<1>, In<Camera>> r_ps = r_pq + r_qs;
  const Displacement<Body, Thruster<1>, In<Camera>> exchanged = r_qs + r_pq;
  RC_ASSERT(r_ps.coordinates() == r_pq.coordinates() + r_qs.coordinates());
  RC_ASSERT(exchanged.coordinates() == r_ps.coordinates());
  const Displacement<Body, Body, In<Camera>> nowhere = r_pq + -r_pq;
  RC_ASSERT(nowhere.coordinates() == Eigen::Vector3d::Zero());
}

// The common point goes: r_ps^c - r_pq^c = r_qs^c, r_ps^c - r_qs^c = r_pq^c.
RC_GTEST_PROP(Displacement, DifferencesCancelAsSumsDo, ()) {
  const auto r_pq = any_displacement<Body, CentreOfMass, Camera>();
  const auto r_ps = any_displacement<Body, Thruster<1>, Camera>();
  const Displacement<CentreOfMass, Thruster<1>, In<Camera>> r_qs = r_ps - r_pq;
  RC_ASSERT(r_qs.coordinates() == (-r_pq + r_ps).coordinates());
  const Displacement<Body, CentreOfMass, In<Camera>> again = r_ps - r_qs;
  RC_ASSERT(again.coordinates() == (r_ps + -r_qs).coordinates());
  const Vector<Camera, si::length> error = error_between(again, r_pq);
  RC_ASSERT(error.coordinates() == again.coordinates() - r_pq.coordinates());
}

// 2. r_qp^c = -r_pq^c.
RC_GTEST_PROP(Displacement, Law2ReversalChangesTheSign, ()) {
  const auto r_pq = any_displacement<Body, CentreOfMass, Camera>();
  const Displacement<CentreOfMass, Body, In<Camera>> r_qp = -r_pq;
  RC_ASSERT(r_qp.coordinates() == -r_pq.coordinates());
}

// 3. r_pq^d = R_c^d r_pq^c.
RC_GTEST_PROP(Displacement, Law3ReexpressionKeepsThePoints, ()) {
  const auto r_c = any_displacement<Body, CentreOfMass, Camera>();
  const auto R_d_from_c = trust_dcm(to<Ground>, from<Camera>, *rotation_matrix());
  const Displacement<Body, CentreOfMass, In<Ground>> r_d = R_d_from_c * r_c;
  RC_ASSERT(r_d.coordinates() == R_d_from_c.matrix() * r_c.coordinates());
}

TEST(Displacement, CoincidentPointsAreNowhereApart) {
  EXPECT_EQ(coincident(of<CentreOfMass>, relative_to<Body>, in<Camera>).coordinates(),
            Eigen::Vector3d::Zero());
  EXPECT_EQ(norm(displacement(of<CentreOfMass>, relative_to<Body>,
                              vector(in<Camera>, 2.0 * si::metre, -3.0 * si::metre, 6.0 * si::metre)))
                .value(),
            7.0);
}

template <class Left, class Right>
concept Adds = requires(const Left& left, const Right& right) {
  left + right;
};
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
using BodyToCentre = Displacement<Body, CentreOfMass, In<Camera>>;
static_assert(!Adds<BodyToCentre, BodyToCentre>);
static_assert(!Adds<BodyToCentre, Displacement<Body, Thruster<1>, In<Camera>>>);
static_assert(!Adds<BodyToCentre, Displacement<CentreOfMass, Thruster<1>, In<Body>>>);
static_assert(!Adds<BodyToCentre, Vector<Camera, si::length>>);
static_assert(!Multiplies<Dcm<Camera, Ground>, BodyToCentre>);

}  // namespace
}  // namespace displacement_test

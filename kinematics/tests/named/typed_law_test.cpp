#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/kinematics/named/motions.hpp>
#include <vectrix/kinematics/samples/slerp.hpp>

#include "words.hpp"

namespace typed_law_test {
using namespace named_words;
namespace {

using I = SomeInertial<'i'>;
using X = Some<'x'>;
using Y = Some<'y'>;

/// A typed function of a user's, which needs an inertial frame.
template <InertialFrame F, class G>
Vector<F, si::length> seen_from(const Dcm<F, G>& R, const Vector<G, si::length>& r) {
  return R * r;
}
const auto seen = [](const auto&... x) { return seen_from(x...); };

TEST(TypedLaw, AppliesAFunctionOfTheUser) {
  const Words words;
  const NamedFrame a = words.graph.frame("a"), b = words.graph.frame("b"), c = words.graph.frame("c");
  const auto see = [](const NamedDcm& R, const NamedVector<si::length>& r) {
    return typed_law<Law<Dcm<I, X>, Vector<X, si::length>>>("seen_from", seen, R, r);
  };
  const auto r_b = vector(In(b), 1.0 * si::metre, 2.0 * si::metre, 3.0 * si::metre);
  const NamedVector<si::length> r_a = see(turned_z(To(a), From(b), 0.5 * si::radian), r_b);
  EXPECT_EQ(r_a.in(), a);
  EXPECT_EQ(r_a.coordinates(), (turned_z(To(a), From(b), 0.5 * si::radian) * r_b).coordinates());
  EXPECT_EQ(message<BadInput>([&] { see(aligned(To(a), From(c)), r_b); }),
            R"(seen_from(R to "a" from "c", a vector in "b"): "c" and "b" are two frames)");
  EXPECT_EQ(message<BadInput>([&] { see(aligned(To(c), From(b)), r_b); }),
            R"("c" is a moving frame; the law needs an inertial one)");
}

// A frame of another graph is another frame, also if it has the same name.
TEST(TypedLaw, TellsTheFramesOfTwoGraphsApart) {
  const Words words, others;
  const auto r = unit_x(In(words.graph.frame("a"))), s = unit_x(In(others.graph.frame("a")));
  EXPECT_EQ(message<BadInput>([&] { cross(r, s); }),
            R"(cross(a vector in "a", a vector in "a"): "a" and "a" are frames of two graphs)");
}

// A product of typed rotations has a type of its own until it is stored.
RC_GTEST_PROP(TypedLaw, NamesAProductOfRotations, ()) {
  const Words words(sometimes());
  const auto R = any_rotation(to<C>, from<B>);
  const auto S = any_rotation(to<B>, from<A>);
  const Dcm<C, A> stored = R * S;
  words.agree([](const auto& x, const auto& y) { return x * y; }, R, S);
  const NamedDcm product = words.graph.named(R * S);
  RC_ASSERT(words.graph.typed(to<C>, from<A>, product).matrix() == stored.matrix());
  const NamedDcm by_law = typed_law<Law<Dcm<X, Y>, Dcm<Y, Some<'z'>>>>(
      "product", [](const auto& x, const auto& y) { return x * y; }, words.named(R), words.named(S));
  RC_ASSERT(by_law.matrix() == product.matrix() && by_law.from() == product.from());
}

TEST(TypedLaw, RefusesAResultWhoseFrameNoOperandHas) {
  const Words words;
  const auto first = [](const std::vector<Vector<X, si::length>>&) { return zero<si::length>(in<X>); };
  EXPECT_EQ(message<BadInput>([&] {
              typed_law<Law<std::vector<Vector<X, si::length>>>>("first", first,
                                                                 std::vector<NamedVector<si::length>>{});
            }),
            "no operand says which frame 'x' of the result is");
}

// What a law makes may be a function of time: an edge of a graph.
RC_GTEST_PROP(TypedLaw, MakesAFunctionOfTime, ()) {
  Words words;
  const auto start = 1.0 * si::second, now = 2.5 * si::second, end = 4.0 * si::second;
  const auto q0 = quaternion(any_rotation(to<A>, from<B>)), q1 = quaternion(any_rotation(to<A>, from<B>));
  const auto typed = Slerp{start, q0, end, q1}(now);
  const auto slerp = typed_law<Law<Quaternion<X, Y>, Quaternion<X, Y>>>(
      "slerp",
      [&](const auto& p, const auto& q) {
        return Slerp{start, p, end, q};
      },
      words.named(q0), words.named(q1));
  RC_ASSERT(words.graph.typed(to<A>, from<B>, slerp(now).rotation()).matrix() == typed.rotation.matrix());
  RC_ASSERT(slerp(now).angular_velocity().coordinates() == typed.angular_velocity.coordinates());
  RC_ASSERT(message<BadInput>([&] { slerp(5.0 * si::second); }) ==
            R"(Slerp of "b" relative to "a": the time 5 s is outside [1 s, 4 s])");
  words.graph.add_edge(edge(To(words.graph.frame("a")), From(words.graph.frame("b")), slerp));
  RC_ASSERT(words.graph.at(now).rotation(to<A>, from<B>).matrix() == typed.rotation.matrix());
}

}  // namespace
}  // namespace typed_law_test

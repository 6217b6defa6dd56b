#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "words.hpp"

namespace named_algebra_test {
using namespace named_words;
namespace {

RC_GTEST_PROP(NamedAlgebra, OfVectorsIsThatOfTypes, ()) {
  const Words words(sometimes());
  const auto r = vector_in<si::length>(in<A>), s = vector_in<si::length>(in<A>);
  const auto F = vector_in<si::force>(in<A>);
  const auto w = any_rate(of<C>, relative_to<B>, in<A>);
  const auto r_pq = any_place(of<Q>, relative_to<P>, in<A>);
  words.agree([](const auto& x) { return 2 * x; }, r);
  words.agree([](const auto& x) { return x * 0.3; }, r);
  words.agree([](const auto& x) { return x / 7; }, r);
  words.agree([](const auto& x) { return (2.0 * si::second) * x; }, F);
  words.agree([](const auto& x) { return x * (2.0 * si::kilogram); }, r);
  words.agree([](const auto& x) { return x / (3.0 * si::second); }, r);
  words.agree([](const auto& x) { return -x; }, r);
  words.agree([](const auto& x) { return (0.3 * si::newton_metre_second / si::radian) * x; }, w);
  const auto dots = [](const auto&... x) { return dot(x...); };
  words.agree(dots, r, F);
  words.agree(dots, w, r);
  words.agree(dots, r, w);
  const auto crosses = [](const auto&... x) { return cross(x...); };
  words.agree(crosses, r, F);
  words.agree(crosses, w, r);
  const auto angles = [](const auto&... x) { return angle_between(x...); };
  words.agree(angles, r, F);
  words.agree(angles, r_pq, r);
  words.agree([](const auto& x) { return direction(x); }, r);
  words.agree([](const auto& x) { return norm(x); }, r);
  words.agree([](const auto& x) { return norm(x); }, r_pq);
  words.agree([](const auto& x) { return squared_norm(x); }, w);
  words.agree(
      [](const auto& x, const auto& y) {
        auto sum = x;
        sum += y;
        sum *= 2.0;
        return sum -= x;
      },
      r, s);
}

RC_GTEST_PROP(NamedAlgebra, OfQuaternionsIsThatOfTypes, ()) {
  const Words words(sometimes());
  const auto q = quaternion(any_rotation(to<C>, from<B>));
  const auto product = [](const auto& x, const auto& y) { return x * y; };
  words.agree(product, q, quaternion(any_rotation(to<B>, from<A>)));
  words.agree(product, q, vector_in<si::length>(in<B>));
  words.agree(product, q, any_rate(of<Q>, relative_to<P>, in<B>));
  words.agree(product, q, any_change(of<Q>, relative_to<P>, in<B>));
  words.agree([](const auto& x) { return inverse(x); }, q);
  words.agree([](const auto& x) { return dcm(x); }, q);
  words.agree([](const auto& x) { return quaternion(x); }, any_rotation(to<C>, from<A>));
  words.agree([](const auto&... x) { return rotate(x...); }, any_rotation(to<A>, from<B>),
              vector_in<si::length>(in<A>));
}

RC_GTEST_PROP(NamedAlgebra, ClaimsOfZeroAndUnitVectorsAreThoseOfTypes, ()) {
  const Words words(sometimes());
  words.agree([](const auto& in_a) { return zero<si::length>(in_a); }, in<A>);
  words.agree([](const auto& in_a) { return unit_x(in_a); }, in<A>);
  words.agree([](const auto& in_a) { return unit_y(in_a); }, in<A>);
  words.agree([](const auto& in_a) { return unit_z(in_a); }, in<A>);
  const auto rest = [](const auto&... x) { return at_rest(x...); };
  const auto steady = [](const auto&... x) { return unaccelerated(x...); };
  words.agree(rest, of<B>, relative_to<A>, in<C>);
  words.agree(rest, of<B>, relative_to<A>, observed_from<D>, in<C>);
  words.agree(steady, of<B>, relative_to<A>, in<C>);
  words.agree(steady, of<B>, relative_to<A>, observed_from<D>, in<C>);
  words.agree([](const auto&... x) { return coincident(x...); }, of<B>, relative_to<A>, in<C>);
  const auto R = any_rotation(to<B>, from<A>);
  const auto axes = [](const auto&... x) { return dcm_from_axes(x...); };
  const auto back = inverse(R);
  words.agree(axes, to<B>, back * unit_x(in<B>), back * unit_y(in<B>), back * unit_z(in<B>));
  words.agree(axes, to<B>, back * unit_x(in<B>), back * unit_z(in<B>), back * unit_y(in<B>));
  const NamedFrame a = words.graph.frame("a");
  const auto x = unit_x(In(a));
  RC_ASSERT(message<BadInput>([&] { dcm_from_axes(To(a), x, x, x); }) ==
            R"(dcm_from_axes(to "a", from "a"): a door takes two frames, and these are one)");
}

TEST(NamedAlgebra, TheZeroVectorHasNoDirection) {
  const Words words;
  words.agree([](const auto& x) { return direction(x); }, zero<si::length>(in<A>));
  words.agree([](const auto&... x) { return angle_between(x...); }, zero<si::length>(in<A>), unit_x(in<A>));
}

}  // namespace
}  // namespace named_algebra_test

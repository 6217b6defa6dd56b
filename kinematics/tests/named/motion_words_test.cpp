#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/kinematics/named/motions.hpp>

#include "words.hpp"

namespace named_motion_words_test {
using namespace named_words;
namespace {

template <class X, class Y> AcceleratingTransform<X, Y> any_motion(Of<Y> y, RelativeTo<X> x) {
  const auto turning =
      accelerating_dcm(any_rotation(to<X>, from<Y>), any_rate(y, x, in<Y>), any_change(y, x, in<Y>));
  return {turning, any_place(y, x, in<X>), velocity(y, x, observed_from<X>, vector_in<si::velocity>(in<X>)),
          acceleration(y, x, observed_from<X>, vector_in<si::acceleration>(in<X>))};
}

RC_GTEST_PROP(NamedMotion, ProductsAndInversesAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto ab = any_motion(of<B>, relative_to<A>);
  const auto bd = any_motion(of<D>, relative_to<B>);
  const auto product = [](const auto& x, const auto& y) { return x * y; };
  const auto reversed = [](const auto& x) { return inverse(x); };
  words.agree(product, ab, bd);
  words.agree(product, moving_transform_of(ab), moving_transform_of(bd));
  words.agree(product, ab.turning, bd.turning);
  words.agree(product, without_acceleration(ab.turning), without_acceleration(bd.turning));
  words.agree(reversed, ab);
  words.agree(reversed, moving_transform_of(ab));
  words.agree(reversed, ab.turning);
  words.agree(reversed, without_acceleration(ab.turning));
  words.agree([](const auto& x) { return without_acceleration(x); }, ab.turning);
  words.agree([](const auto& x) { return moving_transform_of(x); }, ab);
  words.agree([](const auto& x) { return transform_of(x); }, ab);
  words.agree([](const auto& x) { return transform_of(x); }, moving_transform_of(ab));
  const auto together = [](const auto& x) { return coincident(x); };
  words.agree(together, ab.turning.rotation);
  words.agree(together, without_acceleration(ab.turning));
  words.agree(together, ab.turning);
}

RC_GTEST_PROP(NamedMotion, PointsAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto r = vector_in<si::length>(in<A>);
  const auto v = vector_in<si::velocity>(in<A>);
  words.agree([](const auto&... x) { return point_motion(x...); }, of<Q>, relative_to<P>, observed_from<A>, r,
              v);
  const auto motion = point_motion(of<Q>, relative_to<A>, observed_from<A>, r, v);
  const auto a = acceleration(of<Q>, relative_to<A>, observed_from<A>, vector_in<si::acceleration>(in<A>));
  const auto later = point_motion(of<Q>, relative_to<A>, observed_from<A>, vector_in<si::length>(in<A>),
                                  vector_in<si::velocity>(in<A>));
  const auto between = [](const auto&... x) { return hermite(x..., 2.0 * si::second, 0.3 * si::second); };
  words.agree(between, motion, later);
  words.agree([](const auto&... x) { return hermite(x..., 2.0 * si::second, 3.0 * si::second); }, motion,
              motion);
  words.agree([](const auto&... x) { return parallel(x...); }, motion);
  words.agree([](const auto&... x) { return parallel(x...); }, motion, a);
}

RC_GTEST_PROP(NamedMotion, ObserversAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto w = any_rate(of<B>, relative_to<A>, in<C>);
  const auto alpha = any_change(of<B>, relative_to<A>, in<C>);
  const auto r = any_place(of<Q>, relative_to<P>, in<C>);
  const auto v = velocity(of<Q>, relative_to<P>, observed_from<B>, vector_in<si::velocity>(in<C>));
  const auto a = acceleration(of<Q>, relative_to<P>, observed_from<B>, vector_in<si::acceleration>(in<C>));
  const auto carry = [](const auto&... x) { return transport(x...); };
  words.agree(carry, observed_from<A>, v, r, w);
  words.agree(carry, observed_from<A>, a, v, r, alpha, w);
  const auto H = vector_in<si::angular_momentum>(in<C>);
  const auto Hdot = derivative<si::angular_momentum>(observed_from<B>, vector_in<si::torque>(in<C>));
  words.agree(carry, observed_from<A>, Hdot, H, w);
  words.agree([](const auto&... x) { return derivative<si::length>(x...); }, observed_from<A>,
              vector_in<si::velocity>(in<C>));
  words.agree([](const auto& x) { return x.vector(); }, Hdot);
  words.agree([](const auto&... x) { return euler_acceleration(x...); }, alpha, r);
  words.agree([](const auto&... x) { return coriolis_acceleration(x...); }, w, v);
  words.agree([](const auto&... x) { return centrifugal_acceleration(x...); }, w, r);
}

}  // namespace
}  // namespace named_motion_words_test

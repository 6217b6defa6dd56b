#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/kinematics/named/screws.hpp>

#include "words.hpp"

namespace named_screw_words_test {
using namespace named_words;
namespace {

template <class X, class Y, class Z, class W>
Twist<X, Y, At<Z>, In<W>> any_twist(Of<Y>, RelativeTo<X>, At<Z>, In<W>) {
  return twist(at<Z>, any_rate(of<Y>, relative_to<X>, in<W>), vector_in<si::velocity>(in<W>));
}
template <class X, class Y, class Z, class W>
TwistRate<X, Y, At<Z>, In<W>> any_twist_rate(const Twist<X, Y, At<Z>, In<W>>& V) {
  return twist_rate(V, any_change(of<Y>, relative_to<X>, in<W>), vector_in<si::acceleration>(in<W>));
}
template <class Y, class X> Transform<Y, X> any_transform(To<Y> y, From<X> x) {
  return {any_rotation(y, x), any_place(of<X>, relative_to<Y>, in<Y>)};
}

RC_GTEST_PROP(NamedTwist, LawsAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto V_ab = any_twist(of<B>, relative_to<A>, at<P>, in<C>);
  const auto V_bd = any_twist(of<D>, relative_to<B>, at<P>, in<C>);
  const auto V_ad = any_twist(of<D>, relative_to<A>, at<P>, in<C>);
  words.agree([](const auto&... x) { return twist(x...); }, at<P>, any_rate(of<B>, relative_to<A>, in<C>),
              vector_in<si::velocity>(in<C>));
  words.agree([](const auto& x, const auto& y) { return x + y; }, V_ab, V_bd);
  words.agree([](const auto& x, const auto& y) { return x - y; }, V_ad, V_ab);
  words.agree([](const auto& x, const auto& y) { return x - y; }, V_ad, V_bd);
  words.agree([](const auto& x) { return -x; }, V_ab);
  words.agree([](const auto& x) { return x.angular_velocity(); }, V_ab);
  words.agree([](const auto& x) { return x.velocity(); }, V_ab);
  words.agree([](const auto& x) { return ad(x); }, V_ab);
  const auto product = [](const auto& x, const auto& y) { return x * y; };
  words.agree(product, any_rotation(to<Q>, from<C>), V_ab);
  words.agree(product, any_transform(to<Q>, from<C>), any_twist(of<B>, relative_to<A>, at<C>, in<C>));
  words.agree([](const auto&... x) { return shift(x...); }, V_ab, any_place(of<Q>, relative_to<P>, in<C>));
  const auto V_q = any_twist(of<B>, relative_to<A>, at<Q>, in<C>);
  words.agree([](const auto&... x) { return point_velocity(x...); }, of<Q>, V_q);
  words.agree([](const auto& x) { return adjoint(x); }, any_transform(to<Q>, from<C>));
  const auto named = words.named(V_ab);
  RC_ASSERT(contains(message<BadInput>([&] { named - named; }), ": one pair twice"));
}

RC_GTEST_PROP(NamedTwist, DerivativesAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto V_ab = any_twist(of<B>, relative_to<A>, at<P>, in<C>);
  const auto V_bd = any_twist(of<D>, relative_to<B>, at<P>, in<C>);
  const auto Vdot_ab = any_twist_rate(V_ab), Vdot_ab_2 = any_twist_rate(V_ab);
  words.agree([](const auto&... x) { return twist_rate(x...); }, V_ab,
              any_change(of<B>, relative_to<A>, in<C>), vector_in<si::acceleration>(in<C>));
  words.agree([](const auto&... x) { return chain(x...); }, Vdot_ab, any_twist_rate(V_bd), V_ab, V_bd);
  words.agree([](const auto& x) { return -x; }, Vdot_ab);
  words.agree([](const auto& x) { return x.velocity_rate(); }, Vdot_ab_2);
  words.agree([](const auto& x) { return x.angular_acceleration(); }, Vdot_ab);
  const auto product = [](const auto& x, const auto& y) { return x * y; };
  words.agree(product, any_rotation(to<Q>, from<C>), Vdot_ab);
  words.agree(product, any_transform(to<Q>, from<C>),
              any_twist_rate(any_twist(of<B>, relative_to<A>, at<C>, in<C>)));
  words.agree([](const auto&... x) { return shift(x...); }, Vdot_ab, any_place(of<Q>, relative_to<P>, in<C>));
  words.agree([](const auto&... x) { return particle_acceleration(x...); }, V_ab, Vdot_ab);
  const auto V_q = any_twist(of<B>, relative_to<A>, at<Q>, in<C>);
  words.agree([](const auto&... x) { return point_acceleration(x...); }, of<Q>, V_q, any_twist_rate(V_q));
  const AcceleratingTransform<A, B> motion{
      accelerating_dcm(any_rotation(to<A>, from<B>), any_rate(of<B>, relative_to<A>, in<B>),
                       any_change(of<B>, relative_to<A>, in<B>)),
      any_place(of<B>, relative_to<A>, in<A>),
      velocity(of<B>, relative_to<A>, observed_from<A>, vector_in<si::velocity>(in<A>)),
      acceleration(of<B>, relative_to<A>, observed_from<A>, vector_in<si::acceleration>(in<A>))};
  words.agree([](const auto& x) { return twist_of(x); }, moving_transform_of(motion));
  words.agree([](const auto& x) { return twist_of(x); }, motion);
  words.agree([](const auto& x) { return twist_rate_of(x); }, motion);
}

RC_GTEST_PROP(NamedScrew, LawsAreThoseOfTypes, ()) {
  const Words words(sometimes());
  const auto screws = [](const auto&... x) { return screw(x...); };
  words.agree(screws, of<B>, relative_to<A>, vector_in<si::angle>(in<A>), vector_in<si::length>(in<A>));
  words.agree(screws, of<B>, relative_to<A>, vector_in<si::angle>(in<B>), vector_in<si::length>(in<B>));
  words.agree([](const auto&... x) { return screw_rate(x...); }, of<B>, relative_to<A>,
              vector_in<si::angular_velocity>(in<B>), vector_in<si::velocity>(in<B>));
  const auto xi = screw(of<B>, relative_to<A>, vector_in<si::angle>(in<A>), vector_in<si::length>(in<A>));
  words.agree([](const auto& x) { return exp(x); }, xi);
  words.agree([](const auto& x) { return log(x); }, any_transform(to<A>, from<B>));
  words.agree([](const auto& x) { return -x; }, xi);
  words.agree([](const auto& x) { return x.rotation_vector(); }, xi);
  words.agree([](const auto& x) { return x.in_turned(); }, xi);
  words.agree([](const auto& x) { return ad(x); }, xi);
  words.agree([](const auto& x) { return left_jacobian(x); }, xi);
  words.agree([](const auto& x) { return screw_axis(x); }, xi);
  const ScrewAxis<A> axis{unit_y(in<A>), vector_in<si::length>(in<A>), 0.3 * si::radian, 2.0 * si::metre};
  words.agree([](const auto&... x) { return screw_along(x...); }, of<B>, relative_to<A>, axis);
  const auto V_b = any_twist(of<B>, relative_to<A>, at<B>, in<B>);
  const auto V_a = any_twist(of<B>, relative_to<A>, at<A>, in<A>);
  const auto t = 0.7 * si::second;
  const auto X = any_transform(to<A>, from<B>);
  const auto agree = [&](const auto& V) {
    words.agree([](const auto&... x) { return rate(x...); }, xi, V);
    words.agree([&](const auto& x) { return held(x, t); }, V);
    words.agree([&](const auto&... x) { return moved(x..., t); }, X, V);
  };
  agree(V_b);
  agree(V_a);
  const auto small = screw(of<B>, relative_to<A>, vector<si::angle>(in<A>, Eigen::Vector3d(0.1, 0.2, 0.3)),
                           vector_in<si::length>(in<A>));
  const auto xidot = rate(small, V_b);
  words.agree([](const auto&... x) { return twist_from(x...); }, small, xidot, in<B>);
  words.agree([](const auto&... x) { return twist_from(x...); }, small, xidot, in<A>);
}

}  // namespace
}  // namespace named_screw_words_test

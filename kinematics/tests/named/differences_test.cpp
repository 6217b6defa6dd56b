#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "named_values.hpp"

// Differences between named frames are those of types, checked at run time.
namespace values_test {
namespace {

template <class X, class Y = X>
concept Subtracts = requires(const X& x, const Y& y) {
  x - y;
};
template <class X>
concept SubtractsInPlace = requires(X& x) {
  x -= x;
};
static_assert(Subtracts<NamedAngularVelocity> && Subtracts<NamedDisplacement>);
static_assert(Subtracts<NamedVelocity> && Subtracts<NamedAcceleration>);
// The transport term of a difference of angular accelerations is lost, whatever its frames; so it is with
// types.
static_assert(!Subtracts<NamedAngularAcceleration>);
template <class P, class Q> using Rate = AngularVelocity<P, Q, In<Itrf>>;
template <class P, class Q> using Change = AngularAcceleration<P, Q, In<Itrf>>;
static_assert(Subtracts<Rate<Body, Camera>, Rate<Body, Ground>>);
static_assert(!Subtracts<Change<Body, Camera>, Change<Body, Ground>>);
static_assert(Subtracts<Rate<Body, Ground>, Rate<Camera, Ground>>);
static_assert(!Subtracts<Change<Body, Ground>, Change<Camera, Ground>>);
static_assert(!Subtracts<Change<Body, Ground>>);
static_assert(!SubtractsInPlace<NamedAngularVelocity> && !SubtractsInPlace<NamedVelocity>);

/// Values whose frames a, b, c and d are also types.
struct BoundValues : Values {
  BoundValues() {
    graph.bind<Body>(a);
    graph.bind<Camera>(b);
    graph.bind<Itrf>(c);
    graph.bind<Ground>(d);
  }
};

template <class X> bool identical(const X& one, const X& other) {
  if constexpr (requires { one.observed_from(); })
    if (one.observed_from() != other.observed_from()) return false;
  return one.of() == other.of() && one.relative_to() == other.relative_to() && one.in() == other.in() &&
         one.coordinates() == other.coordinates();
}

/// x_ad, x_ab and x_db by make(of, relative_to, numbers): their differences, named and typed, and the errors.
template <class Make> void follows_the_types(const BoundValues& x, const Make& make) {
  const auto x_ad = make(of<Ground>, relative_to<Body>, x.v1);
  const auto x_ab = make(of<Camera>, relative_to<Body>, x.v2);
  const auto x_db = make(of<Camera>, relative_to<Ground>, x.v2);
  const auto named = [&](const auto& typed) { return x.graph.named(typed); };
  RC_ASSERT(identical(named(x_ad) - named(x_ab), named(x_ad - x_ab)));
  RC_ASSERT(identical(named(x_ab) - named(x_db), named(x_ab - x_db)));
  const auto estimate = make(of<Ground>, relative_to<Body>, x.v2);
  const auto error = error_between(named(estimate), named(x_ad));
  const auto expected = named(error_between(estimate, x_ad));
  RC_ASSERT(error.in() == expected.in() && error.coordinates() == expected.coordinates());
}

RC_GTEST_PROP(NamedDifference, FollowsTheTypes, ()) {
  const BoundValues x;
  follows_the_types(x, [](auto q, auto p, const Eigen::Vector3d& w) {
    return angular_velocity(q, p, vector<si::angular_velocity>(in<Itrf>, w));
  });
  follows_the_types(x, [](auto q, auto p, const Eigen::Vector3d& r) {
    return displacement(q, p, vector<si::length>(in<Itrf>, r));
  });
  follows_the_types(x, [](auto q, auto p, const Eigen::Vector3d& v) {
    return velocity(q, p, observed_from<Body>, vector<si::velocity>(in<Itrf>, v));
  });
  follows_the_types(x, [](auto q, auto p, const Eigen::Vector3d& a) {
    return acceleration(q, p, observed_from<Body>, vector<si::acceleration>(in<Itrf>, a));
  });
}

// With places of the points, every displacement is a difference of two places. Of all pairs of displacements
// between four points, those that have exactly one end in common cancel.
RC_GTEST_PROP(NamedDifference, CancelsExactlyOneEnd, ()) {
  const Values x;
  const std::array points{x.a, x.b, x.c, x.d};
  const std::array<Eigen::Vector3d, 4> places{*triple(), *triple(), *triple(), *triple()};
  const auto place = [&](NamedFrame point) {
    return places[static_cast<std::size_t>(std::find(points.begin(), points.end(), point) - points.begin())];
  };
  const auto between = [&](NamedFrame q, NamedFrame p) { return x.r(q, p, x.c, place(q) - place(p)); };
  int cancelled = 0, twice = 0;
  for (const NamedFrame q : points)
    for (const NamedFrame p : points)
      for (const NamedFrame s : points)
        for (const NamedFrame o : points) {
          if (q == p || s == o) continue;
          const auto r_pq = between(q, p), r_os = between(s, o);
          if ((q == s) != (p == o)) {
            const auto r = r_pq - r_os;
            RC_ASSERT(distance(r.coordinates(), place(r.of()) - place(r.relative_to())) <= rounding);
            ++cancelled;
          } else {
            const std::string why = refusal([&] { r_pq - r_os; });
            RC_ASSERT(contains(why, q == s ? ": one pair twice" : ": no frame cancels"));
            twice += q == s;
          }
        }
  RC_ASSERT(cancelled == 48 && twice == 12);
}

RC_GTEST_PROP(NamedDifference, IsRefusedWithItsFrames, ()) {
  const Values x;
  const auto w_ab_c = x.w(x.b, x.a, x.c, x.v1);
  const std::string begin = R"(difference of w of "b" relative to "a" in "c" and )";
  RC_ASSERT(refusal([&] { w_ab_c - x.w(x.b, x.a, x.c, x.v2); }) ==
            begin +
                R"(w of "b" relative to "a" in "c": one pair twice; for two estimates, error_between(x, y))");
  RC_ASSERT(refusal([&] { w_ab_c - x.w(x.d, x.b, x.c, x.v2); }) ==
            begin + R"(w of "d" relative to "b" in "c": no frame cancels, "b" and "d" are two frames, )"
                    R"("a" and "b" are two frames)");
  RC_ASSERT(refusal([&] { w_ab_c - x.w(x.d, x.a, x.a, x.v2); }) ==
            begin + R"(w of "d" relative to "a" in "a": "c" and "a" are two frames)");
  const Values other;
  RC_ASSERT(refusal([&] { w_ab_c - other.w(other.d, other.a, other.c, x.v2); }) ==
            begin + R"(w of "d" relative to "a" in "c": "c" and "c" are frames of two graphs)");
  RC_ASSERT(
      refusal([&] { x.v(x.b, x.a, x.d, x.c, x.v1) - x.v(x.d, x.a, x.a, x.c, x.v2); }) ==
      R"(difference of v of "b" relative to "a" observed from "d" in "c" and v of "d" relative to "a" observed from "a" in "c": "d" and "a" are two frames)");
  RC_ASSERT(
      refusal([&] { x.a_of(x.b, x.a, x.d, x.c, x.v1) - x.a_of(x.d, x.b, x.d, x.c, x.v2); }) ==
      R"(difference of a of "b" relative to "a" observed from "d" in "c" and a of "d" relative to "b" observed from "d" in "c": no frame cancels, "b" and "d" are two frames, "a" and "b" are two frames)");
}

RC_GTEST_PROP(NamedDifference, ErrorsAreOfOneQuantity, ()) {
  const Values x;
  const auto w_ab_c = x.w(x.b, x.a, x.c, x.v1);
  const std::string begin = R"(error_between(w of "b" relative to "a" in "c", )";
  RC_ASSERT(refusal([&] { error_between(w_ab_c, x.w(x.d, x.a, x.c, x.v2)); }) ==
            begin + R"(w of "d" relative to "a" in "c"): "b" and "d" are two frames)");
  RC_ASSERT(refusal([&] { error_between(w_ab_c, x.w(x.b, x.d, x.c, x.v2)); }) ==
            begin + R"(w of "b" relative to "d" in "c"): "a" and "d" are two frames)");
  RC_ASSERT(refusal([&] { error_between(w_ab_c, x.w(x.b, x.a, x.b, x.v2)); }) ==
            begin + R"(w of "b" relative to "a" in "b"): "c" and "b" are two frames)");
  RC_ASSERT(
      refusal([&] { error_between(x.v(x.b, x.a, x.d, x.c, x.v1), x.v(x.b, x.a, x.a, x.c, x.v2)); }) ==
      R"(error_between(v of "b" relative to "a" observed from "d" in "c", v of "b" relative to "a" observed from "a" in "c"): "d" and "a" are two frames)");
  const auto error = error_between(x.alpha(x.b, x.a, x.c, x.v1), x.alpha(x.b, x.a, x.c, x.v2));
  RC_ASSERT(error.in() == x.c && error.coordinates() == x.v1 - x.v2);
}

}  // namespace
}  // namespace values_test

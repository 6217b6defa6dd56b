// mistake: the covariance of an attitude found from weights alone: no error was said
// expect: AttitudeFit<Body, Gcrf
// expect: covariance
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto uncertainty(const Vector<Body, si::length>& sun_b, const Vector<Gcrf, si::length>& sun_i,
                 const Vector<Body, si::force>& pull_b, const Vector<Gcrf, si::force>& pull_i) {
#ifdef REPAIRED
  const auto sigma = 0.01 * si::radian;
  return wahba(to<Body>, from<Gcrf>,
               std::vector{observation(sun_b, sun_i, sigma), observation(pull_b, pull_i, sigma)})
      .covariance;
#else
  return wahba(
             to<Body>, from<Gcrf>,
             std::vector{weighted_observation(sun_b, sun_i, 1.0), weighted_observation(pull_b, pull_i, 2.0)})
      .covariance;
#endif
}

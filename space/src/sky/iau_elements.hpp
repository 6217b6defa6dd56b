#pragma once

#include <span>

#include <vectrix/space/sky/bodies.hpp>

namespace vectrix::detail {

/// a sin(phase + rate T) is added to the right ascension of the pole, d cos(...) to its declination, w
/// sin(...) to the angle of the prime meridian: deg, and deg per Julian century.
struct IauTerm {
  double a, d, w, phase, rate;
};

/// Right ascension and declination of the pole, deg, deg per Julian century; the angle of the prime meridian,
/// deg, deg/day, deg/day^2. At 2000 January 1, 12 h TDB.
struct IauElements {
  double a0, a1, d0, d1, w0, w1, w2;
  std::span<const IauTerm> terms;
};

IauElements iau_elements(Body body);

}  // namespace vectrix::detail

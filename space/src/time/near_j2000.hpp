#pragma once

#include <cmath>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/caller.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix::detail {

/// Throws BadInput unless the epoch is within 1000 years of 2000: the polynomials of precession and of the
/// axes of bodies grow without bound.
inline void require_near_j2000(const Caller& name, const Epoch& epoch) {
  constexpr double j2000 = 2451545.0, limit = 365250.0;  // days
  const auto& tai = epoch.tai();
  if (!(std::abs((tai.day - j2000) + tai.fraction) <= limit))
    throw BadInput(name() + "the Julian date " + text(tai.day) + " is more than 1000 years from 2000");
}

}  // namespace vectrix::detail

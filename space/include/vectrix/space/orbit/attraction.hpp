#pragma once

#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/scalar/batch.hpp>
#include <vectrix/space/caller.hpp>

namespace vectrix::detail {

/// mu/|r|^3. Throws BadInput if mu is not positive, or this is not finite.
template <class S> S attraction(const Caller& name, const S& mu, const S& distance) {
  const S found = mu / (distance * distance * distance);
  if (!(all(mu > S(0)) && all(found - found == S(0)))) [[unlikely]]
    throw BadInput(name() + "mu is " + text(mu) + " m^3/s^2 and |r| " + text(distance) +
                   " m; mu must be positive, mu/|r|^3 finite");
  return found;
}

}  // namespace vectrix::detail

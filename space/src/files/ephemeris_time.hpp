#pragma once

#include <string>

#include <vectrix/space/time/epoch.hpp>

namespace vectrix::detail {

/// Seconds since 2000 January 1, 12 h, in two parts of which the first is whole: one double would be rounded
/// to 1e-7 s.
struct SecondsSince2000 {
  double whole, part;

  /// From a time that was read as one double.
  [[nodiscard]] double since(double seconds) const { return (whole - seconds) + part; }
};

/// The ephemeris time of SPICE, by the formula with which its kernels are made (Moyer 1981), so that UTC
/// comes back exactly. It is within 5e-5 s of TDB:
///     ET = TT + K sin E,  E = M + e sin M,  M = m0 + m1 ET
SecondsSince2000 ephemeris_time(const Epoch& epoch);
SecondsSince2000 terrestrial_time(const Epoch& epoch);

/// Throw BadInput, which begins with `place`, if the time is not finite or farther from 2000 than 9000 years.
Epoch epoch_of_ephemeris_time(const SecondsSince2000& et, const std::string& place);
Epoch epoch_of_terrestrial_time(const SecondsSince2000& tt, const std::string& place);

/// The constants of the formula, as a kernel of leap seconds has them.
struct EphemerisTimeConstants {
  double delta_t_a, k, eb, m0, m1;
};
inline constexpr EphemerisTimeConstants ephemeris_time_constants{32.184, 1.657e-3, 1.671e-2, 6.239996,
                                                                 1.99096871e-7};

}  // namespace vectrix::detail

#pragma once

#include <compare>
#include <cstdint>
#include <vectrix/frames/units.hpp>

namespace vectrix {

/// Time of the Global Positioning System: whole weeks since 1980 January 6, 0 h, not reduced by the 1024
/// weeks that a receiver may count; and the seconds of the week, in [0, 604800).
struct GpsTime {
  std::int64_t week;
  Quantity<si::time> second;

  /// The seconds since 1980 January 6. Rounded to a double, in 2023 to 2.4e-7 s.
  [[nodiscard]] Quantity<si::time> since_1980() const {
    return static_cast<double>(week * 604800) * si::second + second;
  }

  friend auto operator<=>(const GpsTime& a, const GpsTime& b) {
    return a.week != b.week ? std::partial_ordering(a.week <=> b.week)
                            : a.second.value() <=> b.second.value();
  }
  friend bool operator==(const GpsTime& a, const GpsTime& b) {
    return a.week == b.week && a.second == b.second;
  }
};

}  // namespace vectrix

#pragma once

#include <concepts>

#include <vectrix/frames/export.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {

/// A time scale: a way to read and to write an instant. The words are in the namespace `scale`:
///     Epoch::from(scale::tt, "2022-04-14T10:23:20.684")        epoch.text(scale::gps)
/// TAI is the scale of atomic clocks. The others follow from it:
///     TT = TAI + 32.184 s        GPS = TAI - 19 s        UTC = TAI - leap seconds
///     UT1 = TAI + (UT1-TAI)      TDB = TT + a periodic difference of up to 1.7 ms
class TimeScale {
 public:
  enum class Kind { utc, tai, tt, tdb, gps, ut1_by_tai, ut1_by_utc };

  [[nodiscard]] constexpr Kind kind() const { return kind_; }
  /// UT1-TAI or UT1-UTC; 0 in the other scales.
  [[nodiscard]] constexpr const Quantity<si::time>& ut1_offset() const { return ut1_offset_; }
  /// "UTC", "TT", ...
  [[nodiscard]] constexpr const char* name() const {
    constexpr const char* names[] = {"UTC", "TAI", "TT", "TDB", "GPS", "UT1", "UT1"};
    return names[static_cast<int>(kind_)];
  }

 protected:
  constexpr explicit TimeScale(Kind kind) : kind_(kind) {}
  constexpr TimeScale(Kind kind, const Quantity<si::time>& ut1_offset)
      : kind_(kind), ut1_offset_(ut1_offset) {}

 private:
  Kind kind_;
  Quantity<si::time> ut1_offset_{};
};

/// One scale, such as scale::Tt; not TimeScale, which may be any.
template <class Scale>
concept ScaleType = std::derived_from<Scale, TimeScale> && !std::same_as<Scale, TimeScale>;

namespace scale {

/// Coordinated Universal Time, from 1960 on. A Julian date in UTC counts each day as 1, also one of 86401 s.
struct Utc : TimeScale {
  constexpr Utc() : TimeScale(Kind::utc) {}
};
/// International Atomic Time.
struct Tai : TimeScale {
  constexpr Tai() : TimeScale(Kind::tai) {}
};
/// Terrestrial Time.
struct Tt : TimeScale {
  constexpr Tt() : TimeScale(Kind::tt) {}
};
/// Barycentric Dynamical Time at the centre of the Earth, by ERFA's series, eraDtdb: within 3 ns of numerical
/// integrations from 1950 to 2050. A clock on the ground differs by up to 2 microseconds more.
struct Tdb : TimeScale {
  constexpr Tdb() : TimeScale(Kind::tdb) {}
};
/// The time of the Global Positioning System, from 1980 January 6 on.
struct Gps : TimeScale {
  constexpr Gps() : TimeScale(Kind::gps) {}
};
/// Universal Time, the angle of the Earth. It follows from no clock, so it comes with what was observed:
///     scale::Ut1::minus_tai(orientation.parameters(epoch).ut1_minus_tai)
class Ut1 : public TimeScale {
 public:
  Ut1() = delete;  // UT1 needs UT1-TAI: scale::Ut1::minus_tai(...)
  /// Throws BadInput if the difference is not finite. UTC keeps UT1-UTC below 0.9 s. Since 1972 an Epoch
  /// throws BadInput where it would exceed that, as with UT1-UTC in the place of UT1-TAI, or with a leap
  /// second too many unless the result is a UT1-UTC that can be; after the release of ERFA and the last row
  /// of leap_seconds(), 5 s, for some may be missing.
  VECTRIX_EXPORT static Ut1 minus_tai(const Quantity<si::time>& difference);
  /// A leap second changes the difference by 1 s, so this fits one instant: UTC = UT1 - (UT1-UTC), which is
  /// never in a leap second. An Epoch in one throws BadInput, for it would be read as the second after it.
  /// Throws BadInput if the difference exceeds 0.9 s.
  VECTRIX_EXPORT static Ut1 minus_utc(const Quantity<si::time>& difference);

 private:
  using TimeScale::TimeScale;
};

inline constexpr Utc utc{};
inline constexpr Tai tai{};
inline constexpr Tt tt{};
inline constexpr Tdb tdb{};
inline constexpr Gps gps{};

}  // namespace scale
}  // namespace vectrix

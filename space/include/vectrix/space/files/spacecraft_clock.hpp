#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <vectrix/frames/export.hpp>
#include <vectrix/frames/trusted.hpp>
#include <vectrix/space/files/text_kernel.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix {
namespace detail {

struct ClockNumbers;

}  // namespace detail

/// A count of a clock, in its smallest unit, over all partitions, as the attitude kernels of SPICE have it.
struct ClockTicks {
  double count;
};

/// A spacecraft clock, from a clock kernel (SCLK) of type 1:
///     const auto clock = SpacecraftClock::read("ctim_clock.tsc", -152950);
///     clock.epoch(clock.ticks("1/1366002078:186"))
/// Between the pairs of ticks and time in the kernel the clock runs evenly. Where it is set, a new partition
/// begins: "2/0000000100:000". A time is as exact as the double of the ticks, 1e-7 s for a clock that counts
/// milliseconds for decades. Time in TDB is SPICE's ephemeris time: TT + 1.657 ms sin E, within 5e-5 s of
/// TDB.
class VECTRIX_EXPORT SpacecraftClock {
 public:
  /// Throws BadInput with the place in the kernel, if the clock is not there, is not of type 1, or a count or
  /// time of it does not increase.
  static SpacecraftClock of(const TextKernel& kernel, std::int32_t clock);
  static SpacecraftClock read(const std::filesystem::path& file, std::int32_t clock);

  /// The number by which SPICE knows the clock, mostly that of the spacecraft.
  [[nodiscard]] std::int32_t id() const;

  /// Throw BadInput outside what the kernel knows.
  [[nodiscard]] Epoch epoch(const ClockTicks& ticks) const;
  [[nodiscard]] ClockTicks ticks(const Epoch& epoch) const;

  /// Of the fields of the clock, after the number of the partition, between any of . : - , and blanks;
  /// without a partition, if only one has this count. Throws BadInput for any other text, and for a count
  /// that its partition does not have.
  [[nodiscard]] ClockTicks ticks(std::string_view text) const;
  /// Rounded to the next tick, "1/1366002078.186".
  [[nodiscard]] std::string text(const ClockTicks& ticks) const;

  /// How far ticks may be from an instant by rounding alone: 4 ulp of the ticks and of the time, and the
  /// 1e-10 s of an Epoch.
  [[nodiscard]] double rounding(detail::Trusted, double ticks) const;
  /// Around a count that the clock has.
  [[nodiscard]] double seconds_per_tick(detail::Trusted, double ticks) const;

 private:
  explicit SpacecraftClock(std::shared_ptr<const detail::ClockNumbers> numbers);

  std::shared_ptr<const detail::ClockNumbers> numbers_;
};

}  // namespace vectrix

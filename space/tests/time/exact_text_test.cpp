#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include <vectrix/space/time/exact_text.hpp>

namespace vectrix::exact_text_test {
namespace {

TEST(ExactText, HasAsManyDecimalsAsItNeeds) {
  for (const char* const text :
       {"2026-11-29T00:00:00.000", "2026-11-29T00:00:00.125", "2026-11-29T00:00:00.000001",
        "2026-11-29T23:59:59.999999999", "2016-12-31T23:59:60.500"})
    EXPECT_EQ(exact_text(Epoch::from_utc(text), scale::utc), text);
}

RC_GTEST_PROP(ExactText, IsReadBackAsTheSameEpoch, ()) {
  const auto second = *rc::gen::inRange<std::int64_t>(0, 2'000'000'000);
  const auto picosecond = *rc::gen::inRange<std::int64_t>(0, 1'000'000'000'000);
  const auto any = Epoch::from_gps_seconds(second, 1e-12 * static_cast<double>(picosecond));
  for (const TimeScale& scale :
       {TimeScale(scale::utc), TimeScale(scale::tai), TimeScale(scale::tt), TimeScale(scale::gps)}) {
    const Epoch read = Epoch::from(scale, exact_text(any, scale));
    constexpr double coarsest = 2e-11;  // s: of a text within a day, and of an epoch
    RC_ASSERT(std::abs((read - any).value()) <= coarsest);
    RC_ASSERT(Epoch::from(scale, exact_text(read, scale)) == read);
  }
}

}  // namespace
}  // namespace vectrix::exact_text_test

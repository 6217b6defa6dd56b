#include "report/thinning.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>

namespace vectrix::cli::thinning_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

RC_GTEST_PROP(Thinning, KeepsTheExtremesOfEveryPartAndItsGaps, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 400), most = *rc::gen::inRange<std::size_t>(2, 200);
  std::vector<Report::Curve> curves(*rc::gen::inRange<std::size_t>(1, 4));
  for (auto& curve : curves)
    for (std::size_t i = 0; i < count; ++i) {
      const int value = *rc::gen::inRange(-10, 10);
      curve.values.push_back(value == -10 ? nan : value);
    }
  const auto kept = kept_samples(curves, most);
  RC_ASSERT(std::is_sorted(kept.begin(), kept.end(), std::less_equal<>()) || kept.size() == 1);
  RC_ASSERT(kept.front() == 0U);
  RC_ASSERT(kept.back() == count - 1);
  if (count <= most) {
    RC_ASSERT(kept.size() == count);
    return;
  }
  const std::size_t parts = std::max<std::size_t>(1, most / (2 * curves.size()));
  RC_ASSERT(kept.size() <= 2 + parts * 3 * curves.size());
  for (const auto& curve : curves)
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t from = part * count / parts, until = (part + 1) * count / parts;
      const auto summary = [&](const auto& places) {
        double low = infinity, high = -infinity;
        bool gap = false;
        for (const std::size_t i : places) {
          if (i < from || i >= until) continue;
          low = std::fmin(low, curve.values[i]);
          high = std::fmax(high, curve.values[i]);
          gap = gap || std::isnan(curve.values[i]);
        }
        return std::tuple(low, high, gap);
      };
      std::vector<std::size_t> all(count);
      std::iota(all.begin(), all.end(), std::size_t{0});
      RC_ASSERT(summary(kept) == summary(all));
    }
}

RC_GTEST_PROP(Thinning, PassesOverNoGap, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 400), most = *rc::gen::inRange<std::size_t>(4, 200);
  const auto gaps_of_100 = *rc::gen::inRange(0, 100);
  std::vector<bool> are_gaps;
  for (std::size_t i = 0; i < count; ++i) are_gaps.push_back(*rc::gen::inRange(0, 100) < gaps_of_100);
  const auto kept = even_samples(are_gaps, most);
  RC_ASSERT(kept.size() <= most);
  RC_ASSERT(kept.front() == 0U);
  RC_ASSERT(kept.back() == count - 1);
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
    RC_ASSERT(kept[k] < kept[k + 1]);
    if (are_gaps[kept[k]] || are_gaps[kept[k + 1]]) continue;
    for (std::size_t i = kept[k]; i < kept[k + 1]; ++i) RC_ASSERT(!are_gaps[i]);
  }
}

}  // namespace
}  // namespace vectrix::cli::thinning_test

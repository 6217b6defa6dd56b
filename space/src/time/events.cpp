#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/events.hpp>

namespace vectrix::detail {
namespace {

struct Sample {
  Epoch epoch;
  double value;
};

class Search {
 public:
  Search(const char* name, const NumberOfEpoch& f, const EventOptions& options)
      : name_(name), f_(f), tolerance_(options.tolerance.value()) {
    constexpr double least = 1e-10;  // s: ten times the rounding of the clock
    if (!(tolerance_ >= least && std::isfinite(tolerance_))) {
      throw BadInput(name_ + "the tolerance is " + text(tolerance_) + " s; it has to be at least 1e-10 s");
    }
  }

  // The changes of sign, and whether f is positive before the first.
  struct Result {
    bool starts_positive = false;
    std::vector<ZeroCrossing> crossings;
  };
  [[nodiscard]] Result over(const TimeSpan& span, const Quantity<si::time>& step) const {
    if (!(step.value() > 0.0 && std::isfinite(step.value()))) {
      throw BadInput(name_ + "the step is " + text(step.value()) + " s");
    }
    Result result;
    std::optional<Sample> before;  // the last instant at which f was not zero
    std::optional<Epoch> zero;     // an instant since then at which it was
    const auto take = [&](const Sample& now) {
      if (now.value == 0.0) {
        if (zero) {
          throw BadInput(name_ + "the function is 0 at " + text(*zero) + " and at " + text(now.epoch) +
                         "; it has to change its sign at a zero");
        }
        zero = now.epoch;
        return;
      }
      const bool positive = now.value > 0.0;
      if (!before) {
        result.starts_positive = positive;
      } else if (positive != (before->value > 0.0)) {
        result.crossings.push_back(
            {zero ? *zero : zero_between(*before, now), positive ? Crossing::rising : Crossing::falling});
      }
      before = now;
      zero.reset();
    };
    const EpochRange grid = every(step, span);
    for (const Epoch& epoch : grid) take(at(epoch));
    if (grid[grid.size() - 1] < span.end()) take(at(span.end()));
    return result;
  }

 private:
  [[nodiscard]] Sample at(const Epoch& epoch) const {
    const double value = value_at(epoch);
    if (!std::isfinite(value)) {
      throw BadInput(name_ + "the function is " + text(value) + " at " + text(epoch));
    }
    return {epoch, value};
  }
  [[nodiscard]] double value_at(const Epoch& epoch) const {
    try {
      return f_(epoch);
    } catch (const BadInput& error) {
      throw BadInput(name_ + "at " + text(epoch) + ": " + error.what());
    } catch (const std::exception& error) {
      std::throw_with_nested(std::runtime_error(name_ + "at " + text(epoch) + ": " + error.what()));
    } catch (...) {
      std::throw_with_nested(std::runtime_error(name_ + "at " + text(epoch) + ": the function threw"));
    }
  }

  [[nodiscard]] Epoch zero_between(const Sample& left, const Sample& right) const {
    const double length = (right.epoch - left.epoch).value();
    const auto after = [&](double seconds) {
      return std::min(left.epoch + seconds * si::second, right.epoch);
    };
    // Below the tolerance or, for steps of years, the rounding of the seconds from the left instant.
    const double width = std::max(tolerance_, 4.0 * std::numeric_limits<double>::epsilon() * length);
    std::uintmax_t evaluations = 500;  // bisection alone would need 100
    const auto [a, b] = boost::math::tools::toms748_solve(
        [&](double seconds) { return at(after(seconds)).value; }, 0.0, length, left.value, right.value,
        [width](double low, double high) { return high - low <= width; }, evaluations);
    return after(a + 0.5 * (b - a));
  }

  std::string name_;
  const NumberOfEpoch& f_;
  double tolerance_;
};

}  // namespace

std::vector<ZeroCrossing> zero_crossings(const TimeSpan& span, const Quantity<si::time>& step,
                                         const NumberOfEpoch& f, const EventOptions& options) {
  return Search("events: ", f, options).over(span, step).crossings;
}

std::vector<TimeSpan> positive_intervals(const TimeSpan& span, const Quantity<si::time>& step,
                                         const NumberOfEpoch& f, const EventOptions& options) {
  const auto found = Search("intervals: ", f, options).over(span, step);
  std::vector<TimeSpan> intervals;
  std::optional<Epoch> start;
  if (found.starts_positive) start = span.start();
  for (const ZeroCrossing& crossing : found.crossings) {
    if (crossing.direction == Crossing::rising) {
      start = crossing.epoch;
    } else {
      intervals.push_back(from_until(*start, crossing.epoch));
      start.reset();
    }
  }
  if (start) intervals.push_back(from_until(*start, span.end()));
  return intervals;
}

}  // namespace vectrix::detail

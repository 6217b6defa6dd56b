#include <algorithm>
#include <cmath>
#include <vector>

#include <vectrix/frames/errors.hpp>
#include <vectrix/kinematics/samples/divided_differences.hpp>

#include "orbit_source.hpp"

namespace vectrix::detail {
namespace {

constexpr int highest_degree = 27;  // of SPICE

/// States at times that are evenly spaced (types 8 and 12) or not (9 and 13), with the polynomial through
/// those of a window around t: Lagrange's of position and of velocity, each for itself (8 and 9), or
/// Hermite's (12 and 13). A window of an even number has t in its middle step, of an odd number the nearest
/// state in its middle; at the ends it stays inside.
class StatesSource final : public OrbitSource {
 public:
  StatesSource(const OrbitPart& part, int type);

  [[nodiscard]] PlainMotion at(const SecondsSince2000& time) const override;

 private:
  void load(const OrbitPart& part, std::uint64_t low, std::uint64_t high);
  [[nodiscard]] std::size_t first_of_window(const SecondsSince2000& time, std::size_t low) const;

  bool is_hermite_;
  std::uint64_t count_ = 0, from_ = 0;  // of all states; the first that was loaded
  std::size_t window_ = 0;
  std::vector<double> times_, states_;
};

StatesSource::StatesSource(const OrbitPart& part, int type) : is_hermite_(type == 12 || type == 13) {
  const bool is_even = type == 8 || type == 12;
  const std::uint64_t all = part.array.size, trailer = is_even ? 4 : 2;
  if (all < trailer) part.fail(": a segment of " + text(all) + " numbers");
  const auto end = part.read_finite(all - trailer, trailer);
  count_ = part.count(end.back(), "the number of states", 1.0, static_cast<double>(all));
  const double most = is_hermite_ ? highest_degree / 2 : highest_degree;
  window_ =
      1 + part.count(end[trailer - 2], is_hermite_ ? "the size of a window less 1" : "the degree", 1.0, most);
  constexpr std::uint64_t states_of_entry = 100;
  const std::uint64_t expected =
      count_ * (is_even ? 6 : 7) + (is_even ? 0 : (count_ - 1) / states_of_entry) + trailer;
  if (expected != all)
    part.fail(": " + text(count_) + " states of type " + text(type) + " are " + text(expected) +
              " numbers; it has " + text(all));
  if (count_ < window_) part.fail(": a window has " + text(window_) + " of " + text(count_) + " states");

  if (is_even) {
    const double start = end[0], step = end[1];
    if (!(step > 0.0)) part.fail(": the step is " + text(step) + " s");
    const auto before = [&](double t) {
      return static_cast<std::uint64_t>(
          std::clamp(std::floor((t - start) / step), 0.0, static_cast<double>(count_ - 1)));
    };
    load(part, before(part.first), before(part.last) + 1);
    for (std::size_t i = 0; i < times_.size(); ++i) times_[i] = start + static_cast<double>(from_ + i) * step;
  } else {
    const auto before = [&](double t) {
      std::uint64_t low = 0, high = count_;  // states not after t
      while (low < high) {
        const std::uint64_t middle = low + (high - low) / 2;
        if (part.read(6 * count_ + middle, 1).front() <= t) {
          low = middle + 1;
        } else {
          high = middle;
        }
      }
      return low == 0 ? 0 : low - 1;
    };
    load(part, before(part.first), before(part.last) + 1);
    times_ = part.read_finite(6 * count_ + from_, times_.size());
  }
  for (std::size_t i = 1; i < times_.size(); ++i) {
    if (!(times_[i] > times_[i - 1]))
      part.fail(", state " + text(from_ + i + 1) + ": its time is " + text(times_[i]) + " s, after " +
                text(times_[i - 1]));
  }
  constexpr double rounding = 1e-6;  // s, some ulp of a time
  const bool starts_late = from_ == 0 && times_.front() > part.first + rounding,
             ends_early = from_ + times_.size() == count_ && times_.back() < part.last - rounding;
  if (starts_late || ends_early)
    part.fail(": the states are of " + text(times_.front()) + " to " + text(times_.back()) +
              " s, and the segment of " + text(part.first) + " to " + text(part.last) + " s");
}

void StatesSource::load(const OrbitPart& part, std::uint64_t low, std::uint64_t high) {
  from_ = low < window_ ? 0 : low - window_;
  const std::uint64_t end = std::min(count_, high + window_ + 1);
  states_ = part.read_finite(6 * from_, 6 * (end - from_));
  times_.resize(end - from_);
}

std::size_t StatesSource::first_of_window(const SecondsSince2000& time, std::size_t low) const {
  std::size_t middle = low;
  if (window_ % 2 == 1 && low + 1 < times_.size() && time.since(times_[low + 1]) > -time.since(times_[low]))
    ++middle;
  const std::size_t before = (window_ - 1) / 2;
  return std::min(middle < before ? 0 : middle - before, times_.size() - window_);
}

PlainMotion StatesSource::at(const SecondsSince2000& time) const {
  const auto next = std::upper_bound(times_.begin(), times_.end(), time,
                                     [](const SecondsSince2000& t, double at) { return t.since(at) < 0.0; });
  const auto low = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - times_.begin() - 1, 0));
  const std::size_t first = first_of_window(time, low), end = first + window_;
  const auto state = [&](std::size_t i, std::size_t part) -> Eigen::Vector3d {
    return Eigen::Map<const Eigen::Vector3d>(&states_[6 * i + 3 * part]);
  };
  NewtonPolynomial<double, highest_degree> position, velocity;
  // From the middle outwards, so that the differences are multiplied by small numbers. Times count from it.
  const std::size_t middle = std::clamp(low, first, end - 1);
  std::size_t before = middle + 1, behind = middle + 1;
  const auto add = [&](std::size_t i) {
    const double t = times_[i] - times_[middle];
    if (is_hermite_) {
      position.add(t, state(i, 0), state(i, 1));
    } else {
      position.add(t, state(i, 0));
      velocity.add(t, state(i, 1));
    }
  };
  while (before > first || behind < end) {
    if (before > first) add(--before);
    if (behind < end) add(behind++);
  }
  const double t = time.since(times_[middle]);
  constexpr double metres = 1e3;
  position.divide();
  const auto now = position.at(t);
  if (is_hermite_) return {metres * now.value, metres * now.first};
  velocity.divide();
  return {metres * now.value, metres * velocity.at(t).value};
}

}  // namespace

std::unique_ptr<const OrbitSource> states_source(const OrbitPart& part, int type) {
  return std::make_unique<StatesSource>(part, type);
}

}  // namespace vectrix::detail

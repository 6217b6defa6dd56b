#include "attitude_records.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vectrix/frames/errors.hpp>
#include <vectrix/kinematics/samples/slerp.hpp>

namespace vectrix::detail {
namespace {

constexpr std::uint64_t directory_step = 100;

std::uint64_t directory(std::uint64_t count) {
  return (count - 1) / directory_step;
}

std::uint64_t count_at(const DafFile& file, const DafFile::Array& array, std::uint64_t at,
                       const std::string& place, const char* what) {
  const double count = file.read(array, at, 1).front();
  if (!(count >= 1.0 && count <= static_cast<double>(array.size)) || count != std::floor(count))
    throw BadInput(place + ": the number of " + what + " is " + text(count) + ", in a segment of " +
                   text(array.size) + " numbers");
  return static_cast<std::uint64_t>(count);
}

/// How many of the `count` numbers of a segment, which increase, are not above `limit`, or are below it.
std::uint64_t count_until(const DafFile& file, const DafFile::Array& array, std::uint64_t at,
                          std::uint64_t count, double limit, bool with_limit) {
  std::uint64_t low = 0, high = count;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    const double number = file.read(array, at + middle, 1).front();
    if (number < limit || (with_limit && number == limit)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

}  // namespace

AttitudeLayout attitude_layout(const DafFile& file, const DafFile::Array& array, const std::string& place) {
  const int type = array.integers[2];
  const bool has_rates = array.integers[3] == 1;
  AttitudeLayout layout{type, type == 2 ? 8U : has_rates ? 7U : 4U, 0, 0, 0, 0, 0};
  const auto fit = [&](std::uint64_t expected, std::uint64_t count) {
    if (expected != array.size)
      throw BadInput(place + ": " + text(count) + " records of type " + text(type) + " are " +
                     text(expected) + " numbers; it has " + text(array.size));
  };
  if (type == 2) {
    // Ten numbers of each record and a directory: the size says how many there are.
    std::uint64_t n = directory_step * (array.size + 1) / (10 * directory_step + 1);
    if (n > 0 && 10 * n + directory(n) > array.size) --n;
    n = std::max<std::uint64_t>(n, 1);
    fit(10 * n + directory(n), n);
    layout.records = layout.intervals = n;
    layout.ticks = layout.starts = 8 * n;
    layout.stops = 9 * n;
    return layout;
  }
  layout.records = count_at(file, array, array.size - 1, place, "records");
  const std::uint64_t n = layout.records;
  layout.ticks = n * layout.stride;
  std::uint64_t size = layout.ticks + n + directory(n) + 1;
  if (type == 3) {
    if (array.size < 2) fit(2, n);
    layout.intervals = count_at(file, array, array.size - 2, place, "intervals");
    if (layout.intervals > n)
      throw BadInput(place + ": it has " + text(layout.intervals) + " intervals and " + text(n) + " records");
    layout.starts = size - 1;
    size += layout.intervals + directory(layout.intervals) + 1;
  }
  fit(size, n);
  return layout;
}

AttitudeRecords::AttitudeRecords(std::string place, const DafFile& file, const DafFile::Array& array,
                                 double first, double last, double rounding)
    : place_(std::move(place)),
      layout_(attitude_layout(file, array, place_)),
      first_(std::max(first, array.doubles[0])),
      last_(std::min(last, array.doubles[1])),
      rounding_(rounding) {
  if (layout_.type == 1) load_pointing(file, array);
  if (layout_.type == 2) load_rotating(file, array);
  if (layout_.type == 3) load_interpolated(file, array);
}

void AttitudeRecords::fail(const std::string& reason) const {
  throw BadInput(place_ + reason);
}

void AttitudeRecords::require_increasing(const std::vector<double>& numbers, std::uint64_t from,
                                         const char* what) const {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i]) || (i != 0 && !(numbers[i] > numbers[i - 1])))
      fail(", " + std::string{what} + " " + text(from + i + 1) + ": the ticks are " + text(numbers[i]) +
           (i == 0 ? "" : ", after " + text(numbers[i - 1])));
  }
}

void AttitudeRecords::check_records(std::span<const double> records, std::uint64_t from) const {
  const std::size_t stride = layout_.stride;
  for (std::size_t i = 0; i < records.size(); i += stride) {
    const double* const x = &records[i];
    const double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
    double rest = 0.0;
    for (std::size_t k = 4; k < stride; ++k) rest += std::abs(x[k]);
    constexpr double least = 1e-290;  // of a square that is not rounded
    if (square > least && square + rest < HUGE_VAL) [[likely]]
      continue;
    const std::string record = ", record " + text(from + i / stride + 1) + ": ";
    for (std::size_t k = 0; k < stride; ++k) {
      if (!std::isfinite(x[k])) fail(record + "its number " + text(k + 1) + " is " + text(x[k]));
    }
    fail(record + "a quaternion of norm " + text(std::sqrt(square)));
  }
}

void AttitudeRecords::load_records(const DafFile& file, const DafFile::Array& array, std::uint64_t from,
                                   std::uint64_t end) {
  ticks_ = file.read(array, layout_.ticks + from, end - from);
  require_increasing(ticks_, from, "record");
  // Each block is checked while it is in the cache.
  constexpr std::uint64_t records_of_block = 4096;
  const std::uint64_t stride = layout_.stride;
  records_.resize((end - from) * stride);
  for (std::uint64_t at = from; at < end; at += records_of_block) {
    const std::uint64_t count = std::min(records_of_block, end - at);
    const auto block = std::span(records_).subspan((at - from) * stride, count * stride);
    file.read(array, at * stride, block);
    check_records(block, at);
  }
}

void AttitudeRecords::load_pointing(const DafFile& file, const DafFile::Array& array) {
  const auto count = [&](double limit, bool with) {
    return count_until(file, array, layout_.ticks, layout_.records, limit, with);
  };
  load_records(file, array, std::min(count(first_ - rounding_, false), count(last_ + rounding_, true)),
               count(last_ + rounding_, true));
}

void AttitudeRecords::load_interpolated(const DafFile& file, const DafFile::Array& array) {
  const std::uint64_t n = layout_.records;
  const std::uint64_t before = count_until(file, array, layout_.ticks, n, first_, true);
  const std::uint64_t behind = count_until(file, array, layout_.ticks, n, last_, false);
  // One record more on each side, for a start or an end that is off by rounding.
  const std::uint64_t from = before < 2 ? 0 : before - 2, end = std::max(from, std::min(behind + 2, n));
  load_records(file, array, from, end);
  begins_.assign(ticks_.size(), 0);
  if (ticks_.empty()) return;
  const std::uint64_t k0 = count_until(file, array, layout_.starts, layout_.intervals, ticks_.front(), false);
  const std::uint64_t k1 = count_until(file, array, layout_.starts, layout_.intervals, ticks_.back(), true);
  const auto starts = file.read(array, layout_.starts + k0, std::max(k0, k1) - k0);
  require_increasing(starts, k0, "interval");
  if (from == 0 && (starts.empty() || starts.front() != ticks_.front()))
    fail(", interval 1: it does not begin with the first record");
  std::size_t i = 0;
  for (const double start : starts) {
    while (i < ticks_.size() && ticks_[i] < start) ++i;
    if (i == ticks_.size() || ticks_[i] != start)
      fail(", an interval begins at " + text(start) + " ticks, where there is no record");
    begins_[i] = 1;
  }
}

void AttitudeRecords::load_rotating(const DafFile& file, const DafFile::Array& array) {
  const std::uint64_t n = layout_.records;
  const std::uint64_t before = count_until(file, array, layout_.ticks, n, first_, true);
  const std::uint64_t behind = count_until(file, array, layout_.ticks, n, last_, true);
  const std::uint64_t from = before < 2 ? 0 : before - 2, end = std::max(from, std::min(behind + 1, n));
  load_records(file, array, from, end);
  stops_ = file.read(array, layout_.stops + from, end - from);
  for (std::size_t i = 0; i < ticks_.size(); ++i) {
    const std::string interval = ", interval " + text(from + i + 1) + ": ";
    if (!(stops_[i] >= ticks_[i]) || !std::isfinite(stops_[i]))
      fail(interval + "it goes from " + text(ticks_[i]) + " to " + text(stops_[i]) + " ticks");
    if (i + 1 < ticks_.size() && stops_[i] > ticks_[i + 1])
      fail(interval + "it ends at " + text(stops_[i]) + " ticks, after the start of the next, " +
           text(ticks_[i + 1]));
    if (const double rate = records_[8 * i + 7]; !(rate >= 0.0))
      fail(", record " + text(from + i + 1) + ": " + text(rate) + " seconds per tick");
  }
}

bool AttitudeRecords::begins(std::size_t i) const {
  if (layout_.type == 2) return i == 0 || ticks_[i] > stops_[i - 1] + rounding_;
  return layout_.type == 3 && begins_[i] != 0;
}

std::vector<double> AttitudeRecords::ticks_of_interval(std::size_t i) const {
  constexpr double quarter_turn = std::numbers::pi / 2.0, most_steps = 10'000.0;
  const double start = ticks_[i], length = stops_[i] - start;
  const double turn = w_ab_a(i).norm() * length * records_[i * layout_.stride + 7];
  const double steps = std::max(1.0, std::ceil(turn / quarter_turn));
  if (!(steps <= most_steps))
    fail(", record " + text(i + 1) + " of those that were read: it turns by " +
         text(turn / (4.0 * quarter_turn)) + " turns at one rate; attitude() has them");
  std::vector<double> all;
  for (double step = 0.0; step < steps; ++step) all.push_back(start + step / steps * length);
  const bool goes_on = i + 1 < ticks_.size() && !begins(i + 1);
  if (!goes_on && length > 0.0) all.push_back(stops_[i]);
  return all;
}

std::vector<TickSpan> AttitudeRecords::intervals() const {
  std::vector<TickSpan> all;
  for (std::size_t i = 0; i < size(); ++i) {
    const double end = layout_.type == 2 ? stops_[i] : ticks_[i];
    if (i == 0 || begins(i)) {
      all.push_back({ticks_[i], end});
    } else {
      all.back().to = end;
    }
  }
  std::vector<TickSpan> within;
  for (const TickSpan& span : all)
    if (span.to >= first_ - rounding_ && span.from <= last_ + rounding_)
      within.push_back({std::max(span.from, first_), std::min(span.to, last_)});
  return within;
}

Eigen::Quaterniond AttitudeRecords::q_a_from_b(std::size_t i) const {
  // v^b = R(q) v^a. The norm is in the range of doubles, its square may not be.
  const double* const x = &records_[i * layout_.stride];
  return Eigen::Quaterniond(x[0], -x[1], -x[2], -x[3]).normalized();
}

Eigen::Vector3d AttitudeRecords::w_ab_a(std::size_t i) const {
  const double* const x = &records_[i * layout_.stride + 4];
  return {x[0], x[1], x[2]};
}

// From the record i to the next one, unless there an interval begins.
bool AttitudeRecords::is_step(std::size_t i) const {
  return i + 1 < ticks_.size() && begins_[i + 1] == 0;
}

std::optional<AttitudeRecords::Place> AttitudeRecords::find(double ticks) const {
  if (!(ticks >= first_ - rounding_ && ticks <= last_ + rounding_)) return std::nullopt;
  const auto next = std::upper_bound(ticks_.begin(), ticks_.end(), ticks);
  const auto behind = static_cast<std::size_t>(next - ticks_.begin());
  if (layout_.type == 2) {
    if (behind > 0 && ticks <= stops_[behind - 1] + rounding_)
      return Place{behind - 1, std::min(ticks, stops_[behind - 1]) - ticks_[behind - 1]};
    if (behind < ticks_.size() && ticks >= ticks_[behind] - rounding_) return Place{behind, 0.0};
    return std::nullopt;
  }
  if (behind > 0 && is_step(behind - 1))
    return Place{behind - 1, (ticks - ticks_[behind - 1]) / (ticks_[behind] - ticks_[behind - 1])};
  // The end of an interval, or within rounding behind it or before the next one.
  if (behind > 1 && is_step(behind - 2) && ticks <= ticks_[behind - 1] + rounding_)
    return Place{behind - 2, 1.0};
  if (behind < ticks_.size() && is_step(behind) && ticks >= ticks_[behind] - rounding_)
    return Place{behind, 0.0};
  return std::nullopt;
}

bool AttitudeRecords::is_alone(double ticks) const {
  if (layout_.type != 3) return false;
  const auto next = std::lower_bound(ticks_.begin(), ticks_.end(), ticks - rounding_);
  const auto i = static_cast<std::size_t>(next - ticks_.begin());
  return next != ticks_.end() && *next <= ticks + rounding_ && begins_[i] != 0 && !is_step(i);
}

double AttitudeRecords::ticks_of_step(const Place& where) const {
  return layout_.type == 2 ? 0.0 : ticks_[where.record + 1] - ticks_[where.record];
}

KernelTurn AttitudeRecords::at(const Place& where, double seconds_per_step) const {
  struct First : moving_frame {};
  struct Next : moving_frame {};
  const Eigen::Quaterniond q0 = q_a_from_b(where.record);
  if (layout_.type == 2) {
    // The turn is about an axis that is fixed in a and in b.
    const Eigen::Vector3d w_ab_b = q0.conjugate() * w_ab_a(where.record);
    const double seconds = where.part * records_[where.record * layout_.stride + 7];
    return {ConstantTurn<double>(q0, w_ab_b * seconds).at(1.0).normalized(), w_ab_b};
  }
  const Eigen::Quaterniond q1 = q_a_from_b(where.record + 1);
  const Eigen::Vector3d theta =
      turn_between(Quaternion<First, Next>{trusted, q0}, Quaternion<First, Next>{trusted, q1});
  return {ConstantTurn<double>(q0, theta).at(where.part), theta / seconds_per_step};
}

Eigen::Vector3d AttitudeRecords::recorded_rate(const Place& where) const {
  if (!has_rates()) fail(": it has no rates");
  if (layout_.type == 2) return w_ab_a(where.record);
  return (1.0 - where.part) * w_ab_a(where.record) + where.part * w_ab_a(where.record + 1);
}

}  // namespace vectrix::detail

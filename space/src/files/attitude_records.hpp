#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <vectrix/space/files/attitude_kernel.hpp>
#include <vectrix/space/files/daf_file.hpp>

namespace vectrix::detail {

/// Where the parts of an attitude segment are, in its elements. `starts` and `stops` are of intervals: of
/// type 2 each record has one, of type 3 there are fewer.
struct AttitudeLayout {
  int type;
  std::uint64_t stride, records, ticks, starts, stops, intervals;
};
/// Throws BadInput, which begins with `place`, if the counts do not fit the size of the segment.
AttitudeLayout attitude_layout(const DafFile& file, const DafFile::Array& array, const std::string& place);

/// From one instant to another, ticks.
struct TickSpan {
  double from, to;
};

/// The part of a segment that a span needs, checked.
class AttitudeRecords {
 public:
  /// From the record before `first` to the one after `last`, in ticks. `rounding` is that of the ticks.
  AttitudeRecords(std::string place, const DafFile& file, const DafFile::Array& array, double first,
                  double last, double rounding);

  [[nodiscard]] const std::string& place() const { return place_; }
  [[nodiscard]] int type() const { return layout_.type; }
  [[nodiscard]] bool has_rates() const { return layout_.stride > 4; }
  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }
  [[nodiscard]] double rounding() const { return rounding_; }
  [[nodiscard]] std::size_t size() const { return ticks_.size(); }
  [[nodiscard]] double ticks(std::size_t i) const { return ticks_[i]; }

  [[nodiscard]] Eigen::Quaterniond q_a_from_b(std::size_t i) const;
  [[nodiscard]] Eigen::Vector3d w_ab_a(std::size_t i) const;
  /// Whether an interval begins with the record, to which none before leads.
  [[nodiscard]] bool begins(std::size_t i) const;
  /// Of type 2: the begin of an interval, its end if the next one does not begin there, and between them
  /// steps of at most a quarter of a turn.
  [[nodiscard]] std::vector<double> ticks_of_interval(std::size_t i) const;
  /// The intervals, within first() and last(); of type 1 all from its first record to its last.
  [[nodiscard]] std::vector<TickSpan> intervals() const;
  /// Where `ticks` is in an interval: the record before it, and the part of the way to the next, 0 to 1; of
  /// type 2 the ticks since the record. Nothing outside of the intervals.
  struct Place {
    std::size_t record;
    double part;
  };
  [[nodiscard]] std::optional<Place> find(double ticks) const;
  /// Whether the only record of an interval is there, so that nothing says how it turns.
  [[nodiscard]] bool is_alone(double ticks) const;
  /// The rate is per tick between records of type 3, for there the turn is even in ticks.
  [[nodiscard]] KernelTurn at(const Place& where, double seconds_per_step) const;
  [[nodiscard]] double ticks_of_step(const Place& where) const;
  [[nodiscard]] Eigen::Vector3d recorded_rate(const Place& where) const;

 private:
  [[nodiscard]] bool is_step(std::size_t i) const;
  void load_pointing(const DafFile& file, const DafFile::Array& array);
  void load_interpolated(const DafFile& file, const DafFile::Array& array);
  void load_rotating(const DafFile& file, const DafFile::Array& array);
  void load_records(const DafFile& file, const DafFile::Array& array, std::uint64_t from, std::uint64_t end);
  void require_increasing(const std::vector<double>& numbers, std::uint64_t from, const char* what) const;
  void check_records(std::span<const double> records, std::uint64_t from) const;
  [[noreturn]] void fail(const std::string& reason) const;

  std::string place_;
  AttitudeLayout layout_;
  double first_, last_, rounding_;  // within the summary of the segment, ticks
  std::vector<double> ticks_, stops_, records_;
  std::vector<char> begins_;  // of type 3: whether an interval begins with the record
};

}  // namespace vectrix::detail

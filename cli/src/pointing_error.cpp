#include "pointing_error.hpp"

#include <algorithm>

#include "direction_tree.hpp"
#include "figures.hpp"
#include "quantile.hpp"
#include "sample_faults.hpp"
#include "target.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Vector3d;

// The windows of so many seconds, in the order of the samples at which they begin.
class Windows {
 public:
  Windows(const AttitudeRecord& record, double seconds, const std::vector<bool>& among)
      : record_(record), seconds_(seconds), among_(among) {
    const double usual = median(durations_of(record));
    if (!(seconds >= usual - rounding))
      throw BadInput("the window of " + detail::text(seconds) + " s is shorter than the steps of " +
                     record.file + ", " + decimals(usual) + " s");
    longest_ = longest_step(record, usual);
  }

  [[nodiscard]] bool counts(std::size_t i) const { return among_.empty() || among_[i]; }
  /// From a sample that counts to last(); it is not whole if a gap or the end comes before its own end.
  void begin(std::size_t first) {
    const auto later = [&](std::size_t i) { return (record_.times[i] - record_.times[first]).value(); };
    stretch_ = std::max(stretch_, first);
    while (stretch_ + 1 < record_.size() && counts(stretch_ + 1) && !is_gap(record_, stretch_, longest_))
      ++stretch_;
    last_ = std::max(last_, first);
    while (last_ < stretch_ && later(last_ + 1) <= seconds_ + rounding) ++last_;
    is_whole_ = last_ != first && (last_ < stretch_ || later(last_) >= seconds_ - rounding);
  }
  [[nodiscard]] std::size_t last() const { return last_; }
  [[nodiscard]] bool is_whole() const { return is_whole_; }

  [[noreturn]] void refuse_all() const {
    throw BadInput("the window of " + detail::text(seconds_) + " s: no stretch without gaps of " +
                   record_.file + " is so long");
  }

 private:
  static constexpr double rounding = 1e-9;  // s: epochs are kept to 1e-11 s, and a sum of steps is a window

  const AttitudeRecord& record_;
  double seconds_, longest_ = 0.0;
  const std::vector<bool>& among_;
  std::size_t last_ = 0, stretch_ = 0;  // the stretch ends at the next gap, or at the end
  bool is_whole_ = false;
};

// Of a sum of unit vectors, those from first to last.
void require_direction(const Vector3d& sum, const AttitudeRecord& record, std::size_t first,
                       std::size_t last) {
  constexpr double of_rounding = 1e-9;  // of the number of unit vectors: what is left of their sum is noise
  if (!(sum.norm() > of_rounding * static_cast<double>(last - first + 1)))
    throw BadInput("in the window from " + record.times[first].utc() +
                   " UTC the directions of the target cancel; they have no mean direction");
}

// From the mean direction of the samples from first to last.
double largest_from_mean(const AttitudeRecord& record, const std::vector<Vector3d>& u, DirectionTree& tree,
                         std::size_t first, std::size_t last) {
  const Vector3d sum = tree.sum(first, last);
  require_direction(sum, record, first, last);
  return angle_between(u[tree.farthest(sum.normalized(), first, last, -1.0).value()], sum);
}

}  // namespace

std::vector<Vector3d> seen_in_body(const AttitudeRecord& record, const std::vector<Vector3d>& directions) {
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < record.size(); ++i)
    all.emplace_back(record.to_reference(i, record.stated).conjugate() * directions[i]);
  return all;
}

std::vector<double> absolute_errors(const std::vector<Vector3d>& in_body, const Vector3d& axis) {
  std::vector<double> all;
  for (const Vector3d& direction : in_body) all.push_back(angle_between(axis, direction));
  return all;
}

RelativeErrors relative_errors(const AttitudeRecord& record, const std::vector<Vector3d>& in_body,
                               double seconds, const std::vector<bool>& among) {
  Windows windows(record, seconds, among);
  RelativeErrors found;
  DirectionTree tree(in_body);
  double largest_distance = 0.0;
  for (std::size_t first = 0; first < record.size(); ++first) {
    if (!windows.counts(first)) continue;
    windows.begin(first);
    if (const auto i = tree.farthest(in_body[first], first, windows.last(), largest_distance)) {
      largest_distance = (in_body[*i] - in_body[first]).norm();
      found.largest_change = angle_between(in_body[first], in_body[*i]);
      found.change_from = first;
      found.change_until = *i;
    }
    if (!windows.is_whole()) {
      ++found.left_out;
      continue;
    }
    found.starts.push_back(first);
    found.errors.push_back(largest_from_mean(record, in_body, tree, first, windows.last()));
  }
  if (found.errors.empty()) windows.refuse_all();
  return found;
}

WindowErrors window_errors(const AttitudeRecord& record, const std::vector<Vector3d>& in_body,
                           const Vector3d& axis, double seconds, const std::vector<bool>& among) {
  Windows windows(record, seconds, among);
  WindowErrors found;
  for (std::size_t first = 0; first < record.size(); ++first) {
    if (!windows.counts(first)) continue;
    windows.begin(first);
    if (!windows.is_whole()) continue;
    const std::size_t last = windows.last();
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = first; i <= last; ++i) sum += in_body[i];
    require_direction(sum, record, first, last);
    found.of_means.push_back(angle_between(axis, sum));
    for (std::size_t i = first; i <= last; ++i) found.from_means.push_back(angle_between(in_body[i], sum));
    first = last;
  }
  if (found.of_means.empty()) windows.refuse_all();
  return found;
}

}  // namespace vectrix::cli

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

// From the mean direction of the samples from first to last.
double largest_from_mean(const AttitudeRecord& record, const std::vector<Vector3d>& u,
                         const DirectionTree& tree, std::size_t first, std::size_t last) {
  const Vector3d sum = tree.sum(first, last);
  constexpr double of_rounding = 1e-9;  // of the number of unit vectors: what is left of their sum is noise
  if (!(sum.norm() > of_rounding * static_cast<double>(last - first + 1)))
    throw BadInput("in the window from " + record.times[first].utc() +
                   " UTC the directions of the target cancel; they have no mean direction");
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
  constexpr double rounding = 1e-9;  // s: epochs are kept to 1e-11 s, and a sum of steps is a window
  const double usual = median(durations_of(record));
  if (!(seconds >= usual - rounding))
    throw BadInput("the window of " + detail::text(seconds) + " s is shorter than the steps of " +
                   record.file + ", " + decimals(usual) + " s");
  const double longest = longest_step(record, usual);
  const auto counts = [&](std::size_t i) { return among.empty() || among[i]; };
  RelativeErrors found;
  // first to last is the window; it is whole up to the next gap, or the end.
  std::size_t last = 0, whole = 0;
  const DirectionTree tree(in_body);
  double largest_distance = 0.0;
  for (std::size_t first = 0; first < record.size(); ++first) {
    const Epoch& start = record.times[first];
    const auto later = [&](std::size_t i) { return (record.times[i] - start).value(); };
    whole = std::max(whole, first);
    if (!counts(first)) continue;
    while (whole + 1 < record.size() && counts(whole + 1) &&
           (record.times[whole + 1] - record.times[whole]).value() <= longest)
      ++whole;
    last = std::max(last, first);
    while (last < whole && later(last + 1) <= seconds + rounding) ++last;
    if (const auto i = tree.farthest(in_body[first], first, last, largest_distance)) {
      largest_distance = (in_body[*i] - in_body[first]).norm();
      found.largest_change = angle_between(in_body[first], in_body[*i]);
      found.change_from = first;
      found.change_until = *i;
    }
    const bool is_whole = last < whole || later(last) >= seconds - rounding;
    if (!is_whole || last == first) {
      ++found.left_out;
      continue;
    }
    found.starts.push_back(first);
    found.errors.push_back(largest_from_mean(record, in_body, tree, first, last));
  }
  if (found.errors.empty())
    throw BadInput("the window of " + detail::text(seconds) + " s: no stretch without gaps of " +
                   record.file + " is so long");
  return found;
}

}  // namespace vectrix::cli

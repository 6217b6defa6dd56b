#include "pointing_error.hpp"

#include <algorithm>

#include "quantile.hpp"
#include "sample_faults.hpp"
#include "target.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Vector3d;

// From the mean direction of the samples from first to last.
double largest_from_mean(const std::vector<Vector3d>& u, std::size_t first, std::size_t last) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = first; i <= last; ++i) sum += u[i];
  double largest = 0.0;
  for (std::size_t i = first; i <= last; ++i) largest = std::max(largest, angle_between(u[i], sum));
  return largest;
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
                               double seconds) {
  constexpr double rounding = 1e-9;  // s: epochs are kept to 1e-11 s, and a sum of steps is a window
  const double usual = faults_of(record).median_step;
  if (!(seconds >= usual - rounding))
    throw BadInput("--window " + detail::text(seconds) + " s is shorter than the steps of " + record.file +
                   ", " + detail::text(usual) + " s");
  const double longest = longest_step(usual);
  RelativeErrors found;
  // first to last is the window; it is whole up to the next gap, or the end.
  std::size_t last = 0, whole = 0;
  for (std::size_t first = 0; first < record.size(); ++first) {
    const Epoch& start = record.times[first];
    const auto later = [&](std::size_t i) { return (record.times[i] - start).value(); };
    whole = std::max(whole, first);
    while (whole + 1 < record.size() && (record.times[whole + 1] - record.times[whole]).value() <= longest)
      ++whole;
    last = std::max(last, first);
    while (last < whole && later(last + 1) <= seconds + rounding) ++last;
    for (std::size_t i = first + 1; i <= last; ++i) {
      const double change = angle_between(in_body[first], in_body[i]);
      if (change <= found.largest_change) continue;
      found.largest_change = change;
      found.change_from = first;
      found.change_until = i;
    }
    const bool is_whole = last < whole || later(last) >= seconds - rounding;
    if (!is_whole || last == first) {
      ++found.left_out;
      continue;
    }
    found.starts.push_back(first);
    found.errors.push_back(largest_from_mean(in_body, first, last));
  }
  if (found.errors.empty())
    throw BadInput("--window " + detail::text(seconds) + " s: no stretch without gaps of " + record.file +
                   " is so long");
  return found;
}

}  // namespace vectrix::cli

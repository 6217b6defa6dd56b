#include <vectrix/space/files/attitude_kernel_writer.hpp>

#include <algorithm>
#include <cmath>

#include <vectrix/frames/errors.hpp>

#include "../time/date.hpp"
#include "daf_writer.hpp"
#include "text_file.hpp"

namespace vectrix::detail {
namespace {

void require_kept(const std::string& place, const AttitudeKernelText& text) {
  constexpr std::size_t longest = 40;
  const auto is_printable = [](char c) { return c >= ' ' && c <= '~'; };
  if (text.segment_name.empty() || text.segment_name.size() > longest ||
      !std::all_of(text.segment_name.begin(), text.segment_name.end(), is_printable))
    throw BadInput(place + ": the name of the segment, '" + excerpt(text.segment_name) +
                   "', is not of 1 to 40 printable characters");
  if (!std::all_of(text.comments.begin(), text.comments.end(),
                   [&](char c) { return is_printable(c) || c == '\n'; }))
    throw BadInput(place + ": the comments have characters that are not printable");
  if (!(text.longest_gap.value() > 0.0))
    throw BadInput(place + ": the longest gap is " + detail::text(text.longest_gap.value()) + " s");
}

void add_with_directory(std::vector<double>& numbers, const std::vector<double>& ticks) {
  constexpr std::size_t step = 100;
  numbers.insert(numbers.end(), ticks.begin(), ticks.end());
  for (std::size_t i = step - 1; i + 1 < ticks.size(); i += step) numbers.push_back(ticks[i]);
}

}  // namespace

void write_kernel_numbers(const std::filesystem::path& file, const AttitudeKernelText& text,
                          const AttitudeKernelNumbers& numbers, const SpacecraftClock& clock,
                          const FrameKernel& frames, const FrameClaim& a, const FrameClaim& b) {
  const std::string place = "attitude kernel " + file.string();
  require_kept(place, text);
  const std::int32_t frame = frames.attitude_id_of(b), reference = frames.id_of(a);
  frames.require_clock(place, frame, clock.id());
  if (numbers.times.empty()) throw BadInput(place + ": there are no samples");

  DafArrayToWrite array{text.segment_name, {}, {frame, reference, 3, numbers.w_ab_a.empty() ? 0 : 1}, {}};
  std::vector<double> ticks, starts;
  for (std::size_t i = 0; i < numbers.times.size(); ++i) {
    ticks.push_back(clock.ticks(numbers.times[i]).count);
    if (i != 0 && !(ticks[i] > ticks[i - 1]))
      throw BadInput(place + ": the sample of " + shown(numbers.times[i]) +
                     " is not a tick after the one before");
    if (i == 0 || (numbers.times[i] - numbers.times[i - 1]).value() > text.longest_gap.value())
      starts.push_back(ticks[i]);
    // The format wants v^b = R(q) v^a.
    const Eigen::Quaterniond& q = numbers.q_a_from_b[i];
    array.numbers.insert(array.numbers.end(), {q.w(), -q.x(), -q.y(), -q.z()});
    if (numbers.w_ab_a.empty()) continue;
    const Eigen::Vector3d& w = numbers.w_ab_a[i];
    if (!w.allFinite()) throw BadInput(place + ": the rate of " + shown(numbers.times[i]) + " is not finite");
    array.numbers.insert(array.numbers.end(), w.begin(), w.end());
  }
  array.doubles = {ticks.front(), ticks.back()};
  add_with_directory(array.numbers, ticks);
  add_with_directory(array.numbers, starts);
  array.numbers.push_back(static_cast<double>(starts.size()));
  array.numbers.push_back(static_cast<double>(ticks.size()));
  constexpr std::size_t most = 2147483647 - 1024;  // words that the format can count
  if (array.numbers.size() + text.comments.size() > most)
    throw BadInput(place + ": " + detail::text(ticks.size()) + " samples are more than one file can count");
  write_file(place, file, daf_bytes_of("CK", array, text.comments));
}

}  // namespace vectrix::detail

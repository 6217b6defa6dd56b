#include "attitude_kernel_record.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "figures.hpp"

namespace vectrix::cli {
namespace {

struct Reference : inertial_frame {};
struct Body : moving_frame {};

// The number of the frame whose attitude is read.
std::int32_t frame_of(const DafFile& file, const KernelWords& words, const FrameKernel& frames) {
  const std::string &named = words.frame, key = words.frame_word.substr(0, words.frame_word.find(' '));
  std::set<std::int32_t> there;
  for (const DafFile::Array& array : file.arrays())
    if (!array.integers.empty()) there.insert(array.integers.front());
  if (there.empty()) throw BadInput(file.place() + ": it has no segments");
  const auto id_of_name = [&] {
    try {
      return frames.attitude_id_of(detail::claim_of<Body>(called<Body>(named)));
    } catch (const BadInput&) {
      throw BadInput(
          words.frame_place + key + ' ' + named + ": this is no number, and " +
          (words.frames.empty() ? "no frame kernel is given" : words.frames + " has no frame of this name"));
    }
  };
  const std::int32_t wanted = named.empty() ? *there.begin() : id_of_name();
  if (named.empty() ? there.size() != 1 : !there.contains(wanted)) {
    std::string list;
    for (const std::int32_t id : there) list += (list.empty() ? "" : ", ") + detail::text(id);
    throw BadInput(words.frame_place + file.place() + ": it has the frames " + list + "; " +
                   (named.empty() ? "missing: " + words.frame_word : key + " is " + named));
  }
  return wanted;
}

// Segments of a frame relative to another spacecraft frame are not multiplied with those of that frame.
void require_in_j2000(const std::vector<AttitudeKernelSegment>& segments, std::int32_t frame,
                      const AttitudeRecord& record, const FrameKernel& frames) {
  constexpr std::int32_t j2000 = 1;
  const auto is_there = [&](std::int32_t some) {
    return std::any_of(segments.begin(), segments.end(), [&](const auto& segment) {
      return segment.frame == some && segment.reference == j2000;
    });
  };
  if (is_there(frame)) return;
  const std::int32_t reference = std::find_if(segments.begin(), segments.end(), [&](const auto& segment) {
                                   return segment.frame == frame;
                                 })->reference;
  throw BadInput(record.file + ": it has " + record.body + " relative to " + frames.shown(reference) +
                 ", not to J2000; the attitude of that frame is " +
                 (is_there(reference) ? "in this file, and the two are not multiplied here: --ck-frame " +
                                            detail::text(reference) + " reads it alone"
                                      : "not in this file"));
}

std::string hidden_segments(const AttitudeKernel& kernel, const std::vector<HiddenAttitude>& hidden) {
  std::map<std::size_t, double> seconds;
  for (const auto& [segment, span] : hidden) seconds[segment] += (span.end() - span.start()).value();
  std::string text;
  for (const auto& [segment, sum] : seconds)
    text += (text.empty() ? "segment " : ", segment ") + detail::text(segment + 1) + " '" +
            kernel.segments()[segment].name + "' for " + shown(sum) + " s";
  return text;
}

}  // namespace

bool is_kernel(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadInput(file.string() + ": cannot be read");
  std::string word(8, ' ');
  in.read(word.data(), static_cast<std::streamsize>(word.size()));
  return word.starts_with("DAF/") || word.starts_with("DAFETF") || word == "NAIF/DAF";
}

void use_leap_seconds_of(const KernelWords& words) {
  if (words.leap_seconds.empty()) return;
  const auto table = read_leap_second_kernel(words.leap_seconds);
  try {
    use_leap_seconds(table);
  } catch (const BadInput& error) {
    throw BadInput(words.leap_seconds + ": " + error.what());
  }
}

AttitudeRecord read_kernel(const std::filesystem::path& file, const KernelWords& words,
                           const Selection& selection) {
  if (words.clock.empty())
    throw BadInput(file.string() + ": a kernel has times of a clock; missing: --sclk FILE");
  const auto frames = words.frames.empty() ? FrameKernel() : FrameKernel::read(words.frames);
  const std::int32_t frame = frame_of(DafFile::open(file), words, frames);
  constexpr std::int32_t frames_of_a_spacecraft = 1000;
  const auto clock =
      SpacecraftClock::read(words.clock, frames.clock_of(frame).value_or(frame / frames_of_a_spacecraft));
  const auto kernel = AttitudeKernel::open(file, clock, frames);

  const KernelFrame* const known = frames.find(frame);
  AttitudeRecord record;
  record.file = file.string();
  record.body = known ? known->name : detail::text(frame);
  record.names_body = known != nullptr;
  record.reference = "GCRF";  // that is what J2000 means in kernels
  record.stated = {Convention::Scalar::first, Convention::Maps::to_body};
  record.rate_axes = RateAxes::reference;
  record.are_normalised = true;
  const TimeSpan all = kernel.span();
  const Epoch first = std::max(all.start(), selection.from.value_or(all.start())),
              last = std::min(all.end(), selection.until.value_or(all.end()));
  if (last < first)
    throw BadInput(record.file + ": its attitude is from " + all.start().utc() + " UTC to " +
                   all.end().utc() + " UTC, none in the times that are asked for");
  const auto span = from_until(first, last);
  require_in_j2000(kernel.segments(), frame, record, frames);
  const auto body = called<Body>(detail::text(frame));
  const auto reference = called<Reference>("J2000");
  for (const auto& [time, q_reference_from_body] :
       kernel.samples(of<Body>, relative_to<Reference>, span, body, reference)) {
    const auto q = inverse(q_reference_from_body).eigen();
    record.times.push_back(time);
    record.numbers.push_back({q.w(), q.x(), q.y(), q.z()});
  }
  record.interval_starts = kernel.interval_starts(of<Body>, relative_to<Reference>, span, body, reference);
  record.hidden_segments =
      hidden_segments(kernel, kernel.hidden(of<Body>, relative_to<Reference>, span, body, reference));
  const auto& segments = kernel.segments();
  if (std::all_of(segments.begin(), segments.end(),
                  [&](const auto& segment) { return segment.has_rates || segment.frame != frame; })) {
    for (const auto& w : kernel.recorded_rates(of<Body>, relative_to<Reference>, span, body, reference))
      record.rates.push_back(w.coordinates());
  }
  if (record.size() < 2)
    throw BadInput(record.file + ": fewer than two records are in the times that are asked for");
  return record;
}

}  // namespace vectrix::cli

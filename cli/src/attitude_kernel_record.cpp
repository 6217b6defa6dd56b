#include "attitude_kernel_record.hpp"

#include <algorithm>
#include <fstream>
#include <set>

#include "figures.hpp"
#include "kernel_chain.hpp"

namespace vectrix::cli {
namespace {

struct Reference : inertial_frame {};
struct Body : moving_frame {};

// Of which frames there are attitudes.
std::set<std::int32_t> frames_in(const DafFile& file) {
  std::set<std::int32_t> there;
  for (const DafFile::Array& array : file.arrays())
    if (!array.integers.empty()) there.insert(array.integers.front());
  if (there.empty()) throw BadInput(file.place() + ": it has no segments");
  return there;
}

// The number of the frame whose attitude is read: one of the file, or one that is mounted.
std::int32_t frame_of(const DafFile& file, const std::set<std::int32_t>& there, const KernelWords& words,
                      const FrameKernel& frames) {
  const std::string &named = words.frame, key = words.frame_word.substr(0, words.frame_word.find(' '));
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
  if (named.empty() ? there.size() != 1 : !there.contains(wanted) && !frames.mounted_on(wanted)) {
    std::string list;
    for (const std::int32_t id : there) list += (list.empty() ? "" : ", ") + detail::text(id);
    throw BadInput(words.frame_place + file.place() + ": it has the frames " + list + "; " +
                   (named.empty() ? "missing: " + words.frame_word : key + " is " + named));
  }
  return wanted;
}

void read_direct(const AttitudeKernel& kernel, std::int32_t frame, const TimeSpan& span,
                 AttitudeRecord& record) {
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
  const auto daf = DafFile::open(file);
  const auto there = frames_in(daf);
  const std::int32_t frame = frame_of(daf, there, words, frames),
                     timed = there.contains(frame) ? frame : *there.begin();
  constexpr std::int32_t frames_of_a_spacecraft = 1000;
  const auto clock =
      SpacecraftClock::read(words.clock, frames.clock_of(timed).value_or(timed / frames_of_a_spacecraft));
  const auto kernel = AttitudeKernel::open(file, clock, frames);

  const KernelFrame* const known = frames.find(frame);
  AttitudeRecord record;
  record.file = file.string();
  record.body = known ? known->name : detail::text(frame);
  record.names_body = known != nullptr;
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
  const auto chain = KernelChain::of(frame, kernel, frames, span, record.file);
  record.reference = chain.reference();
  if (chain.is_direct()) {
    read_direct(kernel, frame, span, record);
  } else {
    multiply(chain, kernel, frames, span, record);
  }
  if (record.size() < 2)
    throw BadInput(record.file + ": fewer than two records are in the times that are asked for");
  return record;
}

}  // namespace vectrix::cli

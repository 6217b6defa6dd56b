#include "sampled_orbit.hpp"

#include <algorithm>
#include <cmath>

#include "attitude_kernel_record.hpp"
#include "convert.hpp"
#include "flown_orbit.hpp"
#include "word.hpp"

namespace vectrix::cli {
namespace {

double seconds_of(const std::string& step) {
  const auto seconds = number_of<double>(step);
  if (!seconds || !(*seconds > 0.0) || !std::isfinite(*seconds))
    throw BadInput("--step " + step + " is no positive number of seconds");
  return *seconds;
}

std::vector<Epoch> instants_of(const SampledOrbit& source) {
  const Words needed{
      {"--from TIME", source.from}, {"--until TIME", source.until}, {"--step SECONDS", source.step}};
  if (const std::string missing = missing_of(needed); !missing.empty())
    throw BadInput(source.file.string() + ": has no samples; missing: " + missing);
  const Epoch first = Epoch::from(source.from), last = Epoch::from(source.until);
  if (!(first < last)) throw BadInput("--until " + source.until + " is not after --from " + source.from);
  const auto steps = every(seconds_of(source.step) * si::second, from_until(first, last));
  constexpr std::int64_t least = 2, most = 10'000'000;
  if (steps.size() < least || steps.size() > most)
    throw BadInput("--step " + source.step + " makes " + detail::text(steps.size()) +
                   " instants; it must be " + detail::text(least) + " to " + detail::text(most));
  std::vector<Epoch> instants;
  constexpr int nanoseconds = 9;  // an Epoch is rounded to 1e-11 s, which a text would show
  for (const Epoch& t : steps)
    instants.push_back(std::min(last, Epoch::from_utc(std::string(t.utc(nanoseconds)))));
  return instants;
}

}  // namespace

bool is_orbit_kernel(const std::filesystem::path& file) {
  return is_kernel(file) && DafFile::open(file).kind() == "SPK";
}

OrbitRecord sampled(const SampledOrbit& source) {
  const auto times = instants_of(source);
  const auto span = from_until(times.front(), times.back());
  const bool is_kernel = is_orbit_kernel(source.file);
  const auto sets = [&] {
    return has_two_lines(source.file) ? read_two_lines(source.file) : read_mean_elements(source.file);
  };
  const FlownOrbit orbit = is_kernel ? orbit_of_kernel(source.file, span)
                                     : orbit_of_elements(sets(), source.file, span, {}, source.satellite);
  OrbitRecord record{source.file.string(), scale::utc, {}, {}};
  record.lines.ref_frame = "GCRF";
  for (const Epoch& t : times) {
    const auto [position, velocity] = orbit(t);
    record.lines.lines.push_back({t, position.coordinates(), velocity.coordinates(), std::nullopt});
  }
  if (!is_kernel) record = relative_to_frame(std::move(record), "TEME", std::nullopt);
  record.computed = {is_kernel ? "the states are computed from what the kernel has"
                               : "the states are computed by SGP4"};
  return record;
}

}  // namespace vectrix::cli

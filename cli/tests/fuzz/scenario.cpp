// Any file is a scenario whose words go together, or is refused.
#include "scenario/scenario.hpp"

#include "space/tests/fuzz/input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  const auto scenario = fuzz::accepted([&] { return cli::read_scenario(file.path()); });
  if (!scenario) return 0;
  for (const auto& each : scenario->requirements)
    if (each.measure >= scenario->measures.size() ||
        !(each.by_budget || (each.degrees > 0.0 && each.degrees <= 180.0)))
      std::abort();
  for (const auto& each : scenario->contributions)
    for (const auto& source : each.error.sources())
      if (!source.mean.allFinite() || !source.covariance.allFinite() || !(source.seconds > 0.0)) std::abort();
  for (const auto& each : scenario->measures)
    if (!each.axis.vector.allFinite()) std::abort();
  return 0;
}

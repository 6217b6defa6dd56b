// Any file has sets of elements, each of which SGP4 carries on to finite numbers, or is refused. The sums in
// column 69 are made right first, or hardly any input would pass them.
#include <sstream>

#include <vectrix/space/orbit/sgp4.hpp>

#include "../orbit/check_sum.hpp"
#include "input_file.hpp"

namespace {

using vectrix::fuzz::accepted;

struct Satellite : vectrix::moving_frame {};

std::string with_right_sums(const std::string& text) {
  std::istringstream in(text);
  std::string result;
  for (std::string line; std::getline(in, line);) result += vectrix::summed(line) + '\n';
  return result;
}

// The theory may end before an epoch.
void carry_on(const vectrix::TwoLineElements& set) {
  using namespace vectrix;
  const auto orbit = accepted([&] { return Sgp4<Satellite>(set, at_most(720.0 * si::hour)); });
  if (!orbit) return;
  for (const double hours : {-168.0, 0.0, 0.01, 719.0}) {
    const Epoch t = set.epoch() + convert<si::time>(hours * si::hour);
    const auto motion = accepted([&] { return orbit->at(t); });
    if (motion && !(motion->position.coordinates().allFinite() && motion->velocity.coordinates().allFinite()))
      std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text = with_right_sums({reinterpret_cast<const char*>(bytes), size});
  const vectrix::fuzz::InputFile file(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  const auto sets = accepted([&] { return vectrix::TwoLineElements::read(file.path()); });
  if (!sets) return 0;
  for (const auto& set : *sets) carry_on(set);
  return 0;
}

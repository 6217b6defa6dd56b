// Any file has sets of elements, each of which SGP4 carries on to finite numbers, or is refused. The sums in
// column 69 are made right first, or hardly any input would pass them.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include <vectrix/space/orbit/sgp4.hpp>

#include "input_file.hpp"

namespace {

struct Satellite : vectrix::moving_frame {};

std::string with_right_sums(const std::string& text) {
  constexpr std::size_t sum_column = 68;
  std::istringstream in(text);
  std::string result;
  for (std::string line; std::getline(in, line);) {
    if (line.size() > sum_column) {
      int sum = 0;
      for (const char c : line.substr(0, sum_column))
        sum += c >= '0' && c <= '9' ? c - '0' : c == '-' ? 1 : 0;
      line[sum_column] = static_cast<char>('0' + sum % 10);
    }
    result += line + '\n';
  }
  return result;
}

void carry_on(const vectrix::TwoLineElements& set) try {
  using namespace vectrix;
  const Sgp4<Satellite> orbit(set, at_most(720.0 * si::hour));
  for (const double hours : {-168.0, 0.0, 0.01, 719.0}) {
    const auto motion = orbit.at(set.epoch() + convert<si::time>(hours * si::hour));
    if (!motion.position.coordinates().allFinite() || !motion.velocity.coordinates().allFinite())
      std::abort();
  }
} catch (const vectrix::BadInput&) {
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) try {
  const std::string text = with_right_sums({reinterpret_cast<const char*>(bytes), size});
  const vectrix::fuzz::InputFile file(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  for (const auto& set : vectrix::TwoLineElements::read(file.path())) carry_on(set);
  return 0;
} catch (const vectrix::BadInput&) {
  return 0;
}

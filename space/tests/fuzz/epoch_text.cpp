// Any text is an instant, whose own text reads back to the nanosecond, or is refused. The first byte chooses
// the scale.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/epoch.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  if (size == 0) return 0;
  const std::array<const TimeScale*, 5> scales{&scale::utc, &scale::tai, &scale::tt, &scale::tdb,
                                               &scale::gps};
  const TimeScale& in = *scales[bytes[0] % scales.size()];
  const std::string_view text(reinterpret_cast<const char*>(bytes + 1), size - 1);
  const auto read = [&]() -> std::optional<Epoch> {
    try {
      return Epoch::from(in, text);
    } catch (const BadInput&) {
      return std::nullopt;
    }
  };
  constexpr double nanosecond = 1e-9;
  if (const auto epoch = read()) {
    for (const auto& written : {epoch->text(in, 9), epoch->day_of_year_text(in, 9)}) {
      if (std::abs((Epoch::from(in, written) - *epoch).value()) > nanosecond) std::abort();
    }
  }
  return 0;
}

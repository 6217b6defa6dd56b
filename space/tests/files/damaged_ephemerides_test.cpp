#include <gtest/gtest.h>

#include <optional>
#include <string>

#include <vectrix/space.hpp>

#include "damage.hpp"
#include "testing/trials.hpp"

// Damaged ephemerides: a reader accepts them, and then what it writes reads back as the same, or throws a
// BadInput with the place and a reason. Under the sanitizers the fuzz programs of both readers do more.
namespace vectrix::damaged_ephemerides_test {
namespace {

const std::string orbit = R"(CCSDS_OEM_VERS = 3.0
CREATION_DATE = 2026-01-01T00:00:00
ORIGINATOR = HERE
META_START
OBJECT_NAME = A
OBJECT_ID = B
CENTER_NAME = EARTH
REF_FRAME = GCRF
TIME_SYSTEM = UTC
START_TIME = 2026-01-01T00:00:00
STOP_TIME = 2026-01-01T00:02:00
META_STOP
COMMENT C
2026-01-01T00:00:00.000 6789.5 -1.25e2 .5 0 7.5 1 0.1 0.2 0.3
2026-01-01T00:01:00.000 6789.5 -1.25e2 .5 0 7.5 1
COVARIANCE_START
EPOCH = 2026-01-01T00:00:00
COV_REF_FRAME = RTN
1
1 2
1 2 3
1 2 3 4
1 2 3 4 5
1 2 3 4 5 6
COVARIANCE_STOP
)";
const std::string attitude = R"(CCSDS_AEM_VERS = 1.0
CREATION_DATE = 2026-01-01T00:00:00
ORIGINATOR = HERE
META_START
OBJECT_NAME = A
OBJECT_ID = B
REF_FRAME_A = GCRF
REF_FRAME_B = SC_BODY_1
ATTITUDE_DIR = A2B
TIME_SYSTEM = TAI
START_TIME = 2026-01-01T00:00:00
STOP_TIME = 2026-01-01T00:02:00
ATTITUDE_TYPE = QUATERNION/RATE
QUATERNION_TYPE = FIRST
RATE_FRAME = REF_FRAME_B
META_STOP
DATA_START
COMMENT C
2026-01-01T00:00:00.000 1 0 0 0 0.1 -2e-1 .3
2026-001T00:01:00.000 .8 .6 0 0 0.1 -2e-1 .3
DATA_STOP
)";

// The message, or nothing if the reader refuses the text as it should.
template <class Message> std::optional<Message> read(const std::string& text, const std::string& place) {
  try {
    return Message::parse(text);
  } catch (const BadInput& error) {
    const std::string what = error.what();
    EXPECT_TRUE(what.starts_with(place)) << what << text;
    EXPECT_NE(what.back(), '\'') << what;
    constexpr std::size_t longest = 500;  // several excerpts, and the reason
    EXPECT_LT(what.size(), place.size() + longest);
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what() << " of\n" << text;
  }
  return std::nullopt;
}

template <class Message> void run(const std::string& text, const std::string& place, std::uint64_t seed) {
  Damage damage(seed);
  int accepted = 0, refused = 0;
  const int times = vectrix_test::trials(4000);
  for (int i = 0; i < times; ++i) {
    const std::string damaged = damage.of(text);
    const auto message = read<Message>(damaged, place);
    ++(message ? accepted : refused);
    if (!message) continue;
    try {
      const std::string written = message->text();
      EXPECT_EQ(Message::parse(written).text(), written) << damaged;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "what was read is not written and read again: " << error.what() << " of\n" << damaged;
    }
  }
  EXPECT_GT(accepted, times / 80);
  EXPECT_GT(refused, times * 3 / 4);
}

TEST(DamagedEphemerides, OfOrbits) {
  run<OrbitEphemerisMessage>(orbit, "orbit ephemeris message", 20261129);
}

TEST(DamagedEphemerides, OfAttitudes) {
  run<AttitudeEphemerisMessage>(attitude, "attitude ephemeris message", 20261130);
}

}  // namespace
}  // namespace vectrix::damaged_ephemerides_test

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <vectrix/space/files/ephemeris_metadata.hpp>

namespace vectrix::canonical_test {

inline Epoch tai(const char* text) {
  return Epoch::from(scale::tai, text);
}

/// What the canonical messages of orbits and attitudes have in common, whatever their version.
inline void expect_canonical(const MessageHeader& header, const EphemerisMetadata& metadata,
                             const std::string& version) {
  EXPECT_EQ(header.version, version);
  EXPECT_EQ(header.comments, std::vector<std::string>{"of the header"});
  EXPECT_EQ(header.creation_date, "2026-01-02T03:04:05");
  EXPECT_EQ(header.originator, "HERE");
  EXPECT_EQ(header.others,
            (std::vector<OtherKeyword>{{"MISSION_PHASE", "cruise, 2"}, {"USER_DEFINED_META_STAR", "1"}}));
  EXPECT_EQ(metadata.comments, std::vector<std::string>{"of the metadata"});
  EXPECT_EQ(metadata.others, (std::vector<OtherKeyword>{{"ZEROTH", "= [m]"}, {"MASS_KG", ""}}));
  EXPECT_EQ(metadata.object_name, "ORBITER");
  EXPECT_EQ(metadata.object_id, "1996-062A");
  EXPECT_EQ(metadata.center_name, "MARS");
  EXPECT_EQ(metadata.time_system.kind(), TimeScale::Kind::tai);
  EXPECT_EQ(metadata.start_time, tai("1996-12-18T12:00:00.331"));
  EXPECT_EQ(metadata.useable_start_time, tai("1996-12-18T12:00:10.331"));
  EXPECT_EQ(metadata.useable_stop_time, tai("1996-12-18T12:00:50.331"));
  EXPECT_EQ(metadata.stop_time, tai("1996-12-18T12:01:00.331"));
}

}  // namespace vectrix::canonical_test

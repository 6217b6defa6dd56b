#include "sample_faults.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::sample_faults_test {
namespace {

const TableColumns columns{
    "t",    scale::utc, {"w", "x", "y", "z"}, {Convention::Scalar::first, Convention::Maps::to_body},
    "GCRF", {}};

std::string written(const std::string& rows) {
  TemporaryFile file("t,w,x,y,z\n" + rows);
  std::ostringstream out;
  write_samples(read_table(file.path(), columns), out);
  return out.str();
}

TEST(SampleFaults, AreOneOrMany) {
  const std::string steps =
      "2026-11-29T00:00:00,1,0,0,0\n2026-11-29T00:00:01,1,0,0,0\n2026-11-29T00:00:02,1,0,0,0\n"
      "2026-11-29T00:00:03,1,0,0,0\n2026-11-29T00:00:04,1,0,0,0\n";
  const std::string one = written(steps + "2026-11-29T00:00:09,-1,0,0,0\n");
  EXPECT_NE(
      one.find("  1 gap, a step longer than three times the usual one; most 5 s, which ends at sample 6, "),
      std::string::npos)
      << one;
  EXPECT_NE(one.find("  1 change from q to -q: the attitude is one"), std::string::npos) << one;
  const std::string two = written(steps + "2026-11-29T00:00:09,-1,0,0,0\n2026-11-29T00:00:15,1,0,0,0\n");
  EXPECT_NE(two.find("  2 gaps, steps longer than three times the usual one; most 6 s"), std::string::npos)
      << two;
  EXPECT_NE(two.find("  2 changes from q to -q"), std::string::npos) << two;
}

TEST(SampleFaults, NeedTwoSamples) {
  TemporaryFile file("t,w,x,y,z\n");
  EXPECT_EQ(complaint([&] { (void)read_table(file.path(), columns); }, file.path()),
            "FILE: there are 0 samples; at least two are needed");
}

}  // namespace
}  // namespace vectrix::cli::sample_faults_test

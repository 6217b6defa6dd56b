#include "replay.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "new_file.hpp"
#include "says.hpp"
#include "scenario_folder.hpp"
#include "stored_report.hpp"

namespace vectrix::cli::replay_files_test {
namespace {

class ReplayFiles : public ::testing::Test, protected ScenarioFolder {
 protected:
  [[nodiscard]] bool run(const std::string& text, bool force = false, bool check = false) {
    folder.written("s.toml", text);
    out.str("");
    Progress silent(nullptr);
    return replay({file(), check, force, "0"}, silent, out);
  }
  /// With --hdf5.
  bool store(const std::string& text, const std::filesystem::path& stored, bool force = false) {
    folder.written("s.toml", text);
    Progress silent(nullptr);
    return replay({file(), false, force, "0", stored}, silent, out);
  }
  std::ostringstream out;
};

TEST_F(ReplayFiles, SaysWhatIsFulfilled) {
  // The body is along the reference, its z axis 68 deg from the Sun of that day.
  EXPECT_FALSE(run(plain));
  EXPECT_TRUE(
      says(out.str(),
           "not fulfilled  off-Sun: absolute error at most 0.5 deg in 95 % of the samples; it is 111."));
  EXPECT_TRUE(says(out.str(), "Not fulfilled: 1 of 1 requirement.\n"));
  EXPECT_TRUE(run(with(plain, "0.5 deg", "179 deg")));
  EXPECT_TRUE(says(out.str(), "Everything required is fulfilled.\n"));
  EXPECT_TRUE(run(std::string(plain).substr(0, std::string(plain).find("[[require]]"))));
  EXPECT_TRUE(says(out.str(), "Nothing is required.\n"));
}

TEST_F(ReplayFiles, OnlyReadsThemForACheck) {
  EXPECT_TRUE(
      run(plain + std::string("[output]\ncsv = \"") + folder.file("o.csv").string() + "\"\n", false, true));
  EXPECT_TRUE(says(out.str(), "s.toml: 1 measure and 1 requirement of body relative to GCRF, 3 samples, "));
  EXPECT_FALSE(std::filesystem::exists(folder.file("o.csv")));
  EXPECT_EQ(complaint([&] { (void)run(with(plain, "z of body", "z of boy"), false, true); }, file()),
            "FILE:12:9: there is no frame 'boy' fixed in the body; the nearest is 'body'");
}

TEST_F(ReplayFiles, AreWrittenOnce) {
  const auto csv = folder.file("o.csv");
  const std::string text = plain + std::string("[output]\ncsv = \"") + csv.string() + "\"\n";
  (void)run(text);
  EXPECT_TRUE(says(out.str(), "Written: " + csv.string()));
  const auto table = CsvTable::read(csv, {"time_utc", "off-Sun_deg"});
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_EQ(complaint([&] { (void)run(text); }, csv), "FILE: exists; --force overwrites it");
  (void)run(text, true);
  const std::string input =
      plain + std::string("[output]\ncsv = \"") + folder.file("a.csv").string() + "\"\n";
  EXPECT_EQ(complaint([&] { (void)run(input, true); }, folder.file("a.csv")),
            "FILE: is the same file as " + folder.file("a.csv").string() + ", which is read");
}

TEST_F(ReplayFiles, LimitTheInstants) {
  EXPECT_EQ(complaint([&] { (void)run(plain + std::string("[time]\nstep = \"0.001 ms\"\n")); }, file()),
            "FILE:19:1: 'time.step' makes 20000001 instants; at most 10000000 are looked at");
}

TEST_F(ReplayFiles, HaveTheColumnsThatAreNamed) {
  EXPECT_EQ(complaint([&] { (void)run(with(plain, "\"t\"", "\"time\"")); }, file()),
            "FILE:5:19: " + folder.file("a.csv").string() +
                " has no column 'time'; there are: t, a, b, c, d, wx, wy, wz");
  EXPECT_EQ(complaint([&] { (void)run(with(plain, "\"d\"]", "\"wxx\"]")); }, file()),
            "FILE:7:11: " + folder.file("a.csv").string() + " has no column 'wxx'; the nearest is 'wx'");
}

TEST_F(ReplayFiles, SayWhatHasNoAttitude) {
  (void)run(plain + std::string("[time]\nstep = \"10 s\"\nend = 2026-11-29T00:01:00Z\n"));
  EXPECT_TRUE(
      says(out.str(), "\nWithout attitude, not judged: 4 of 7 instants, in gaps or outside the samples\n"));
}

TEST_F(ReplayFiles, HaveSamplesAtTheTimes) {
  EXPECT_EQ(
      complaint(
          [&] { (void)run(plain + std::string("[time]\nstep = \"1 s\"\nstart = 2026-11-30T00:00:00Z\n")); },
          file()),
      "FILE:19:1: the samples of " + folder.file("a.csv").string() +
          " are from 2026-11-29T00:00:00.000000 UTC to 2026-11-29T00:00:20.000000 UTC, none from "
          "'time.start' to "
          "'time.end'");
}

TEST_F(ReplayFiles, AreStoredAndReportedAgain) {
  const auto page = folder.file("o.html"), stored = folder.file("o.h5");
  const std::string text = plain + std::string("[output]\nreport = \"") + page.string() + "\"\n";
  EXPECT_FALSE(store(text, stored));
  EXPECT_TRUE(says(out.str(), "Written: " + stored.string()));
  const std::string shown = content(page);
  for (const char* input : {"s.toml", "a.csv"}) std::filesystem::remove(folder.file(input));
  EXPECT_EQ(complaint([&] { stored_report({stored}, out); }, page), "FILE: exists; --force overwrites it");
  stored_report({stored, folder.file("again.html")}, out);
  EXPECT_TRUE(content(folder.file("again.html")) == shown);
  stored_report({.file = stored, .force = true}, out);
  EXPECT_TRUE(content(page) == shown);
  EXPECT_EQ(complaint(
                [&] {
                  stored_report({stored, stored, true}, out);
                },
                stored),
            "FILE: is the same file as " + stored.string() + ", which is read");
}

TEST_F(ReplayFiles, AreStoredWhereNothingIsLost) {
  const auto stored = folder.file("o.h5");
  folder.written("o.h5", "kept");
  EXPECT_EQ(complaint([&] { store(plain, stored); }, stored), "FILE: exists; --force overwrites it");
  EXPECT_EQ(content(stored), "kept");
  EXPECT_EQ(complaint([&] { store(plain, "o.csv"); }),
            "--hdf5 o.csv: the name ends neither in .h5 nor in .hdf5");
  std::filesystem::create_symlink(folder.file("a.csv"), folder.file("a.h5"));
  EXPECT_EQ(complaint([&] { store(plain, folder.file("a.h5"), true); }, folder.file("a.h5")),
            "FILE: is the same file as " + folder.file("a.csv").string() + ", which is read");
  (void)store(plain, stored, true);
  EXPECT_NE(content(stored), "kept");
  EXPECT_FALSE(std::filesystem::exists(folder.file("o.h5.part")));
}

// Also if it is another name of a file: that gets the content.
TEST_F(ReplayFiles, AreWrittenAsAWholeOrNotAtAll) {
  const auto kept = folder.written("kept.h5", "kept"), other = folder.file("other.h5");
  std::filesystem::create_symlink(kept, other);
  const auto half = [](const std::filesystem::path& part) {
    std::ofstream(part) << "half";
    throw BadInput("the disk is full");
  };
  EXPECT_EQ(complaint([&] { write_new(other, half, true); }, other), "FILE: the disk is full");
  EXPECT_EQ(content(other), "kept");
  for (const auto& each : std::filesystem::directory_iterator(folder.file("")))
    EXPECT_NE(each.path().extension(), ".part");
  write_new(other, "new", true);
  EXPECT_EQ(content(kept), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(other));
}

}  // namespace
}  // namespace vectrix::cli::replay_files_test

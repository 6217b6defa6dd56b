#include "result_file/result_file.hpp"

#include <gtest/gtest.h>

#include "figures.hpp"
#include "result_file/schema.hpp"
#include "stored.hpp"

namespace vectrix::cli::result_file_test {
namespace {

struct Stored {
  explicit Stored(const Replayed& flown)
      : replayed(flown), file(replayed.folder->written("r.h5", stored_bytes(replayed.result()))) {}
  explicit Stored(const std::string& text) : Stored(cli::replayed(text)) {}

  Replayed replayed;
  std::filesystem::path file;
};

// In gaps, with rates, with and without a step, an orbit, measures.
std::vector<std::string> flights() {
  const std::string ctim = example("ctim.toml"), sentinel = example("sentinel1.toml");
  const auto cut = [](const std::string& text, const char* from) { return text.substr(0, text.find(from)); };
  const std::string no_measure = cut(sentinel, "[[measure]]");
  const std::string no_orbit = with(cut(sentinel, "[[require]]"), "velocity relative to ITRF", "earth");
  return {ctim, at_samples(ctim), sentinel, no_measure, cut(ctim, "[[require]]")};
}

TEST(ResultFile, GivesThePageOfTheReplay) {
  for (const std::string& text : flights()) {
    const Stored stored(text);
    const std::string page = html(report_of(read_result(stored.file)));
    EXPECT_TRUE(page == html(stored.replayed.report())) << text;  // too long to be shown
  }
}

TEST(ResultFile, ReadsWhatWasWritten) {
  for (const std::string& text : flights()) {
    const Stored stored(text);
    const Result written = stored.replayed.result(), read = read_result(stored.file);
    EXPECT_TRUE(stored_bytes(read) == stored_bytes(written));  // all of it
    EXPECT_EQ(read.attitude.times, written.attitude.times);
    EXPECT_EQ(read.samples.times, written.samples.times);
    EXPECT_EQ(read.samples.rates, written.samples.rates);
    EXPECT_EQ(read.attitude.longest_step, written.attitude.longest_step);
    ASSERT_EQ(read.verdicts.size(), written.verdicts.size());
    for (std::size_t i = 0; i < read.verdicts.size(); ++i) {
      EXPECT_EQ(read.verdicts[i].margin, written.verdicts[i].margin);
      EXPECT_EQ(read.verdicts[i].window, written.verdicts[i].window);
      EXPECT_EQ(read.verdicts[i].when, written.verdicts[i].when);
      EXPECT_EQ(read.verdicts[i].judged, stored.replayed.judged[i].count);
    }
  }
}

TEST(ResultFile, IsReadByTheLibraryOfHdf5) {
  const Stored stored(at_samples(example("ctim.toml")));
  const Flight& flight = stored.replayed.flight;
  const PlainHdf5 file(stored.file);
  const std::size_t count = flight.attitude.size();
  EXPECT_EQ(file.size("/attitude/quaternion"), (std::vector<hsize_t>{count, 4}));
  const auto seconds = file.numbers("/attitude/seconds"), q = file.numbers("/attitude/quaternion"),
             r = file.numbers("/orbit/position"), v = file.numbers("/orbit/velocity"),
             angles = file.numbers("/measures/1/angle"), to_sun = file.numbers("/measures/1/direction");
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(seconds[i], (flight.attitude.times[i] - flight.attitude.times[0]).value());
    const auto unit = flight.attitude.to_reference(i, flight.attitude.stated);
    const Eigen::Vector4d here(q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]),
        there(unit.w(), unit.x(), unit.y(), unit.z());
    EXPECT_TRUE(here == there || here == -there);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      EXPECT_EQ(r[3 * i + k], flight.motions[i].position.coordinates()[axis]);
      EXPECT_EQ(v[3 * i + k], flight.motions[i].velocity.coordinates()[axis]);
      EXPECT_EQ(to_sun[3 * i + k], stored.replayed.measures[0].directions[i][axis]);
    }
    EXPECT_EQ(angles[i], degrees * stored.replayed.measures[0].angles[i]);
  }
  EXPECT_EQ(file.word("/attitude/seconds", "since_utc"), exact_text(flight.attitude.times[0], scale::utc));
  EXPECT_EQ(file.word("/attitude/quaternion", "from"), "body");
  EXPECT_EQ(file.word("/attitude/quaternion", "to"), "GCRF");
  EXPECT_EQ(file.word("/attitude/quaternion", "scalar"), "first");
  EXPECT_EQ(file.word("/orbit/velocity", "unit"), "m/s");
  EXPECT_EQ(file.word("/orbit/velocity", "observed_from"), "GCRF");
  EXPECT_EQ(file.word("/measures/1/angle", "name"), "off-Sun");
  EXPECT_EQ(file.numbers("/verdicts/required"), (std::vector<double>{0.36, 0.02}));
  EXPECT_EQ(file.numbers("/verdicts/margin")[0], stored.replayed.judged[0].figures.margin);
  EXPECT_EQ(file.filters("/attitude/quaternion"),
            (std::vector<H5Z_filter_t>{H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE, H5Z_FILTER_FLETCHER32}));
}

TEST(ResultFile, HasGapsBetweenSamples) {
  const Stored stored(at_samples(example("ctim.toml")));
  const PlainHdf5 file(stored.file);
  const auto seconds = file.numbers("/samples/seconds"), gaps = file.numbers("/samples/gaps");
  std::vector<double> longer;
  for (std::size_t i = 1; i < seconds.size(); ++i)
    if (seconds[i] - seconds[i - 1] > 15.0) longer.insert(longer.end(), {seconds[i - 1], seconds[i]});
  EXPECT_FALSE(gaps.empty());
  EXPECT_EQ(gaps, longer);
}

// Also the rates in the axes of the body.
TEST(ResultFile, HasTheRatesOfTheGyros) {
  const Stored stored(example("sentinel1.toml"));
  const PlainHdf5 file(stored.file);
  const auto w = file.numbers("/samples/rate");
  const auto& rates = stored.replayed.flight.flown.record.rates;
  ASSERT_EQ(w.size(), 3 * rates.size());
  for (std::size_t i = 0; i < rates.size(); ++i) EXPECT_EQ(w[3 * i + 2], rates[i].z());
  EXPECT_EQ(file.word("/samples/rate", "of"), "quaternion axes");
  EXPECT_EQ(file.word("/samples/rate", "relative_to"), "EME2000");
}

TEST(ResultFile, HasAScenarioThatCanBeReadAgain) {
  const ScenarioFolder from;
  from.folder.written("more.toml", "version = 1\ninclude = [\"title.toml\"]\n");
  from.folder.written("title.toml", "version = 1\ntitle = \"\u00c4 \u2192 B\"\n");
  const auto file = from.folder.written(
      "s.toml", "include = [\"more.toml\"]\n" + with(ScenarioFolder::plain, "title = \"T\"\n", ""));
  const Result stored = read_result(from.folder.written("r.h5", stored_bytes(replayed_file(file).result())));
  ASSERT_EQ(stored.scenario.size(), 3U);
  for (const auto& [path, text] : stored.scenario) {
    EXPECT_EQ(text, content(path));
    std::filesystem::remove(path);
    from.folder.written(std::filesystem::path(path).filename().string(), text);
  }
  EXPECT_EQ(read_scenario(file).title, "\u00c4 \u2192 B");
  EXPECT_EQ(stored.texts.inputs.size(), 4U);
}

TEST(ResultFile, DependsOnTheResultAlone) {
  const Replayed flown = cli::replayed(example("ctim.toml"));
  EXPECT_TRUE(stored_bytes(flown.result()) == stored_bytes(flown.result()));
}

TEST(ResultFile, HasWhatThePageSays) {
  // All datasets: with an orbit, rates, and a target that may be hidden.
  const Stored stored(with(example("sentinel1.toml"), "[[measure]]",
                           "[[measure]]\nname = \"off-Sun\"\naxis = \"x of satellite\"\ntarget = \"sun\"\n"
                           "correction = \"geometric\"\n\n[[measure]]"));
  const PlainHdf5 file(stored.file);
  for (const Hdf5Entry& entry : result_entries()) {
    std::string path(entry.path);
    if (const auto at = path.find("/N/"); at != std::string::npos) path.replace(at, 3, "/1/");
    EXPECT_EQ(&result_entry(path), &entry);
    EXPECT_EQ(file.word(path, "meaning"), entry.meaning);
    for (std::size_t begin = 0; begin < entry.words.size();) {
      const std::size_t end = std::min(entry.words.find(", ", begin), entry.words.size());
      const std::string name(entry.words.substr(begin, end - begin));
      EXPECT_GT(H5Aexists_by_name(file.id(), path.c_str(), name.c_str(), H5P_DEFAULT), 0) << path << name;
      begin = end + 2;
    }
  }
  EXPECT_EQ(content(std::filesystem::path(VECTRIX_SOURCE_DIR) / "docs/reference/result_file.md"),
            result_page());
}

}  // namespace
}  // namespace vectrix::cli::result_file_test

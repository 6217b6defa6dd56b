#include "scenario/table.hpp"

#include <gtest/gtest.h>

#include "says.hpp"
#include "scenario/schema.hpp"
#include "scenario_folder.hpp"

namespace vectrix::cli::scenario_table_test {
namespace {

const std::string angles =
    "an angle is a text with one of: deg, rad, mrad, arcmin, arcsec, mas, as \"1 deg\"";

class ScenarioFile : public ::testing::Test, protected ScenarioFolder {};

TEST_F(ScenarioFile, IsReadAsItStands) {
  const Scenario scenario = read(plain);
  EXPECT_EQ(scenario.title, "T");
  EXPECT_EQ(scenario.body, "body");
  EXPECT_EQ(scenario.attitude.file, folder.file("a.csv"));
  EXPECT_EQ(scenario.attitude.columns->quaternion, (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(scenario.measures.at(0).axis.vector, Eigen::Vector3d(0.0, 0.0, 1.0));
  EXPECT_EQ(scenario.requirements.at(0).degrees, 0.5);
  EXPECT_EQ(scenario.inputs, (std::vector<std::filesystem::path>{file(), folder.file("a.csv")}));
}

TEST_F(ScenarioFile, NamesTheNearestKey) {
  EXPECT_EQ(refusal("scalar =", "scaler ="),
            "FILE:8:1: unknown key 'scaler' of 'attitude.quaternion'; the nearest is 'scalar'");
  EXPECT_EQ(refusal("title", "titel"), "FILE:2:1: unknown key 'titel'; the nearest is 'title'");
  EXPECT_EQ(refusal("column =", "x ="),
            "FILE:5:10: unknown key 'x' of 'attitude.time'; there are: column, scale");
  EXPECT_EQ(refusal("[[require]]", "[[requires]]"),
            "FILE:15:3: unknown key 'requires'; the nearest is 'require'");
}

TEST_F(ScenarioFile, NamesAMissingKey) {
  EXPECT_EQ(
      refusal("scalar = \"last\"\n", ""),
      "FILE:6:1: 'attitude.quaternion.scalar' is missing: which of the four numbers is the scalar (one of "
      "\"first\", \"last\")");
  EXPECT_EQ(refusal("title = \"T\"\n", ""), "FILE:1:1: 'title' is missing: what the scenario asks (text)");
  EXPECT_EQ(refusal("axis = \"z of body\"\n", ""),
            "FILE:10:1: 'measure.axis' is missing: what should look at the target: \"-z of body\", \"[0, "
            "0.1, 1] of "
            "body\" (text: an axis, and of which frame)");
}

TEST_F(ScenarioFile, SaysWhichVersionItIs) {
  EXPECT_EQ(refusal("version = 1\n", ""),
            "FILE:1:1: 'version' is missing; this program reads version 1: version = 1");
  EXPECT_EQ(refusal("version = 1", "version = 2"),
            "FILE:1:11: version 2 is not known; this program reads version 1");
  EXPECT_EQ(refusal("version = 1", "version = \"1\""),
            "FILE:1:11: 'version' is a text; needed: whole number from 1 on");
  EXPECT_EQ(refusal("version = 1", "version = -1"),
            "FILE:1:11: 'version' is -1; needed: whole number from 1 on");
}

TEST_F(ScenarioFile, WantsUnits) {
  EXPECT_EQ(refusal("\"0.5 deg\"", "0.5"), "FILE:17:12: 'require.absolute' has no unit; " + angles);
  EXPECT_EQ(refusal("\"0.5 deg\"", "\"0.5 dg\""),
            "FILE:17:17: 'require.absolute' is '0.5 dg': 'dg' is no unit; the nearest is 'deg'; an angle "
            "takes: deg, rad, "
            "mrad, arcmin, arcsec, mas");
  EXPECT_EQ(refusal("\"95 %\"", "\"95 deg\""),
            "FILE:18:15: 'require.percent' is '95 deg': 'deg' is a unit of an angle; a share takes: %");
  EXPECT_EQ(refusal("\"0.5 deg\"", "\"nan deg\""),
            "FILE:17:13: 'require.absolute' is 'nan deg': the number is not finite");
  EXPECT_EQ(refusal("\"0.5 deg\"", "inf"), "FILE:17:12: 'require.absolute' has no unit; " + angles);
  // With an escape the column is that of the text.
  EXPECT_EQ(refusal("\"0.5 deg\"", "\"0.5 \\u0064g\"").substr(0, 12), "FILE:17:12: ");
}

TEST_F(ScenarioFile, WantsTheKindOfItsKeys) {
  EXPECT_EQ(refusal("scalar = \"last\"", "scalar = \"lst\""),
            "FILE:8:10: 'attitude.quaternion.scalar' is 'lst'; the nearest is 'last'; needed: one of "
            "\"first\", \"last\"");
  EXPECT_EQ(refusal("\"geometric\"", "true"),
            "FILE:14:14: 'measure.correction' is true or false; needed: one of \"geometric\", "
            "\"light_time\", \"apparent\"");
  EXPECT_EQ(refusal("[\"a\", \"b\", \"c\", \"d\"]", "[\"a\", \"b\", \"c\"]"),
            "FILE:7:11: 'attitude.quaternion.columns' is an array of 3; needed: 4 texts");
  EXPECT_EQ(refusal("[\"a\", \"b\", \"c\", \"d\"]", "[\"a\", \"b\", \"c\", 4]"),
            "FILE:7:27: 'attitude.quaternion.columns' is a number; needed: 4 texts");
  EXPECT_EQ(refusal("title = \"T\"", "title = \"\""), "FILE:2:9: 'title' is empty");
  EXPECT_EQ(refusal("name = \"off-Sun\"", "name = \"  \""), "FILE:11:8: 'measure.name' is blank");
  EXPECT_EQ(refusal("title = \"T\"", "title = \"a\\nb\""),
            "FILE:2:9: 'title' holds a line break or another control character");
  EXPECT_EQ(refusal("name = \"off-Sun\"", "name = \"off,Sun\""),
            "FILE:11:12: 'measure.name' holds a comma or a quotation mark");
  EXPECT_EQ(refusal("[[measure]]", "[measure]"),
            "FILE:10:1: 'measure' is a table; write [[measure]], once for each");
  EXPECT_EQ(refusal("time = { column = \"t\", scale = \"UTC\" }", "time = \"t\""),
            "FILE:5:8: 'attitude.time' is a text; needed: table");
  EXPECT_EQ(
      refusal_with("[[frame]]\nname = \"f\"\n[frame.dcm]\nrows = [[1, 0, 0], [0, nan, 0], [0, 0, 1]]\n"),
      "FILE:22:24: 'frame.dcm.rows' holds nan, which is not finite");
  EXPECT_EQ(refusal_with("[[frame]]\nname = \"f\"\n[frame.dcm]\nrows = [[1, 0, 0], [0, 1], [0, 0, 1]]\n"),
            "FILE:22:20: 'frame.dcm.rows' is an array of 2; needed: 3 rows of 3 numbers");
  EXPECT_EQ(
      refusal_with("[[frame]]\nname = \"f\"\n[frame.dcm]\nrows = [[1, 0, 0], [0, \"1\", 0], [0, 0, 1]]\n"),
      "FILE:22:24: 'frame.dcm.rows' is a text; needed: 3 rows of 3 numbers");
}

TEST_F(ScenarioFile, WantsTimesWithTheirScale) {
  EXPECT_EQ(refusal_with("[time]\nstart = 2026-11-29T00:00:00\n"),
            "FILE:20:9: 'time.start' does not say its time scale; write it in UTC with a Z at its end, or as "
            "a text: "
            "\"2023-04-20T05:00:00 TT\"");
  EXPECT_EQ(refusal_with("[time]\nstart = 2026-11-29T00:00:00+01:00\n"),
            "FILE:20:9: 'time.start' is 60 minutes from UTC; write it in UTC with a Z at its end");
  EXPECT_EQ(refusal_with("[time]\nstart = 2026-11-29\n"),
            "FILE:20:9: 'time.start' is a date or a time; needed: date and time in UTC with Z, or text that "
            "ends with its scale");
  EXPECT_TRUE(says(refusal_with("[time]\nstart = \"2026-11-29T00:00:00\"\n"), "FILE:20:9: 'time.start': "));
  EXPECT_TRUE(says(refusal_with("[time]\nstart = 1959-11-29T00:00:00Z\n"), "FILE:20:9: 'time.start': "));
  const auto scenario = read(
      std::string(plain) + "[time]\nstart = 2026-11-29T00:00:00.25Z\nend = \"2026-11-29T00:01:09.434 TT\"\n");
  EXPECT_EQ(scenario.start, Epoch::from_utc("2026-11-29T00:00:00.25"));
  EXPECT_EQ(scenario.end, Epoch::from_tt("2026-11-29T00:01:09.434"));
}

TEST_F(ScenarioFile, NamesTheFileThatIsNotThere) {
  EXPECT_EQ(refusal("a.csv", "b.csv"), "FILE:4:8: there is no file " + folder.file("b.csv").string() +
                                           "; names are relative to the folder of this file");
  EXPECT_EQ(refusal("a.csv", "/dev/zero"), "FILE:4:8: /dev/zero is no file");
  EXPECT_EQ(complaint([&] { (void)read_scenario(folder.file("none.toml")); }, folder.file("none.toml")),
            "FILE: cannot be read");
  EXPECT_EQ(complaint([&] { (void)read_scenario(folder.file(".")); }, folder.file(".")),
            "FILE: cannot be read");
}

TEST_F(ScenarioFile, IsToml) {
  EXPECT_EQ(refusal("title = \"T\"", "title = T").substr(0, 10), "FILE:2:9: ");
  EXPECT_EQ(refusal("title = \"T\"", "title = \"T\"\ntitle = \"U\"").substr(0, 7), "FILE:3:");
  EXPECT_EQ(refusal("title = \"T\"", "title = \"\xff\"").substr(0, 7), "FILE:2:");
}

TEST_F(ScenarioFile, TakesTheKeysOfOthers) {
  const std::string orbit =
      "version = 1\n[orbit]\ntle = \"t.tle\"\n[[measure]]\nname = \"second\"\naxis = \"x of body\"\ntarget = "
      "\"earth\"\n";
  folder.written("part.toml", orbit);
  const std::string including = with(plain, "title", "include = [\"part.toml\"]\ntitle");
  const Scenario scenario = read(including);
  EXPECT_EQ(scenario.orbit->elements, folder.file("t.tle"));
  ASSERT_EQ(scenario.measures.size(), 2U);
  EXPECT_EQ(scenario.measures[1].name, "second");
  EXPECT_EQ(scenario.inputs.size(), 4U);
  // In another folder, whose files are named from there.
  std::filesystem::create_directory(folder.file("inner"));
  folder.written("inner/t.tle", "");
  folder.written("inner/part.toml", orbit);
  EXPECT_EQ(read(with(including, "part.toml", "inner/part.toml")).orbit->elements,
            folder.file("inner/t.tle"));
}

TEST_F(ScenarioFile, RefusesAKeyThatIsGivenTwice) {
  folder.written("part.toml", "version = 1\n[attitude]\ngap = \"3 s\"\nfile = \"a.csv\"\n");
  EXPECT_EQ(refusal("title", "include = [\"part.toml\"]\ntitle"),
            "FILE:5:8: 'attitude.file' is given twice; the other place is " +
                folder.file("part.toml").string() + ":4:8");
  folder.written("part.toml", "version = 1\n[attitude]\ngap = \"3 s\"\n");
  EXPECT_EQ(read(with(plain, "title", "include = [\"part.toml\"]\ntitle")).gap, 3.0);
  folder.written("part.toml", "[attitude]\ngap = \"3 s\"\n");
  EXPECT_EQ(complaint([&] { (void)read(with(plain, "title", "include = [\"part.toml\"]\ntitle")); },
                      folder.file("part.toml")),
            "FILE:1:1: 'version' is missing; this program reads version 1: version = 1");
}

TEST_F(ScenarioFile, RefusesToIncludeItself) {
  EXPECT_EQ(refusal("title", "include = [\"s.toml\"]\ntitle"),
            "FILE:2:11: includes " + file().string() + ", which includes this file or is it");
  folder.written("part.toml", "version = 1\ninclude = [\"s.toml\"]\n");
  EXPECT_EQ(complaint([&] { (void)read(with(plain, "title", "include = [\"part.toml\"]\ntitle")); },
                      folder.file("part.toml")),
            "FILE:2:11: includes " + file().string() + ", which includes this file or is it");
  EXPECT_EQ(refusal("title", "include = [\"none.toml\"]\ntitle"),
            "FILE:2:12: there is no file " + folder.file("none.toml").string() +
                "; names are relative to the folder of this file");
}

// ./dev docs writes it.
TEST(ScenarioSchema, IsThePageOfTheReference) {
  EXPECT_EQ(content(std::filesystem::path(VECTRIX_SOURCE_DIR) / "docs/reference/scenario_file.md"),
            schema_page());
}

}  // namespace
}  // namespace vectrix::cli::scenario_table_test

#include "command/pages.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "command/commands.hpp"
#include "says.hpp"
#include "scenario/schema.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::pages_test {
namespace {

// ./dev docs writes them.
TEST(CommandPage, IsThatOfTheReference) {
  const auto reference = std::filesystem::path(VECTRIX_SOURCE_DIR) / "docs/reference";
  std::set<std::string> names;
  for (const CommandDescription& command : described_program("0").commands) {
    names.insert(page_name(command));
    EXPECT_EQ(content(reference / page_name(command)), command_page(command));
  }
  for (const auto& file : std::filesystem::directory_iterator(reference)) {
    const std::string name = file.path().filename();
    EXPECT_TRUE(!name.starts_with("vectrix_") || names.contains(name)) << name << " is of no command";
  }
}

TEST(Described, IsWhatTheParserHas) {
  const ProgramDescription program = described_program("1.2");
  EXPECT_EQ(program.version, "1.2");
  const auto find = [](const auto& all, const std::string& name) {
    for (const auto& each : all)
      if (each.name == name) return each;
    ADD_FAILURE() << name;
    return all.front();
  };
  const CommandDescription convert = find(program.commands, "convert");
  EXPECT_EQ(usage_of(convert), "file out [options]");
  EXPECT_EQ(convert.groups(),
            (std::vector<std::string>{"Options", "A kernel of SPICE", "A table", "A table of an orbit",
                                      "Orbit and Earth, for --frame", "A message"}));
  const OptionDescription out = find(convert.options, "out"), scale = find(convert.options, "--scale"),
                          force = find(convert.options, "--force"), help = find(convert.options, "--help");
  EXPECT_TRUE(out.is_argument() && out.is_file() && out.is_needed);
  EXPECT_EQ(scale.value, "utc|tai|tt|tdb|gps");
  EXPECT_EQ(scale.choices, (std::vector<std::string>{"utc", "tai", "tt", "tdb", "gps"}));
  EXPECT_EQ(scale.group, "A table");
  EXPECT_TRUE(force.value.empty() && !force.is_needed && !scale.is_needed);
  EXPECT_TRUE(help.value.empty());
  for (const CommandDescription& command : program.commands)
    EXPECT_TRUE(command.name != "schema" && command.name != "pages") << "hidden";
}

TEST(Paragraphs, JoinLinesUnlessTheyAreIndented) {
  const auto all = paragraphs("One\ntwo\n\n  three\n    four\nfive");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].lines, (std::vector<std::string>{"One", "two"}));
  EXPECT_TRUE(!all[0].is_indented && all[1].is_indented && !all[2].is_indented);
  EXPECT_EQ(all[1].lines, (std::vector<std::string>{"three", "  four"}));
}

// Lines that begin with a dot are requests.
void expect_requests(const std::string& page) {
  const std::set<std::string> known{".TH", ".SH", ".SS", ".PP", ".TP", ".B",
                                    ".I",  ".BR", ".RS", ".RE", ".nf", ".fi"};
  std::istringstream in(page);
  for (std::string line; std::getline(in, line);) {
    const bool is_request = line.starts_with('.') || line.starts_with('\'');
    EXPECT_TRUE(!is_request || known.contains(line.substr(0, line.find(' ')))) << line;
  }
}

// Which are not hyphens.
std::string with_dashes(const std::string& text) {
  std::string all;
  for (const char c : text) all += c == '-' ? "\\-" : std::string(1, c);
  return all;
}

TEST(Manual, HasEveryOption) {
  const ProgramDescription program = described_program("1.2");
  const std::string page = program_manual(program);
  expect_requests(page);
  EXPECT_TRUE(page.starts_with(".TH VECTRIX 1 \"\" \"vectrix 1.2\""));
  EXPECT_TRUE(says(page, ".SS vectrix convert file out [options]\n"));
  EXPECT_TRUE(says(page, "\\fB\\-\\-scale\\fR \\fIutc|tai|tt|tdb|gps\\fR\nof the time\n"));
  EXPECT_TRUE(says(page, "\\(aq2023\\-04\\-20T05:00:00 UTC\\(aq"));
  for (const CommandDescription& command : program.commands)
    for (const OptionDescription& option : command.options)
      EXPECT_TRUE(option.is_argument() ? says(page, "\n\\fI" + option.name + "\\fR\n")
                                       : says(page, "\n\\fB" + with_dashes(option.name) + "\\fR"));
}

TEST(Manual, KeepsTextAsItIs) {
  const CommandDescription command{"go", "go on", ".dot\n  a\\b\n  .c", {}};
  const std::string page = program_manual({"0", {"", "all", "", {}}, {command}});
  expect_requests(page);
  EXPECT_TRUE(says(page, "\nGo on.\n.PP\n\\&.dot\n.PP\n.RS\n.nf\na\\eb\n\\&.c\n.fi\n.RE\n"));
}

TEST(Manual, HasEveryKeyOfAScenario) {
  const std::string page = scenario_manual("1.2");
  expect_requests(page);
  EXPECT_TRUE(says(page, ".SH [[station]]\n"));
  EXPECT_TRUE(says(page, "\n\\fBquaternion.maps.from\\fR (needed)\n"));
  for (const Key& key : schema().keys)
    for (const Key& inner : key.keys) EXPECT_TRUE(says(page, "\n\\fB" + inner.name + "\\fR")) << key.name;
  EXPECT_TRUE(says(page, "\n\\fBversion\\fR (needed)\nwhole number from 1 on: "));
}

}  // namespace
}  // namespace vectrix::cli::pages_test

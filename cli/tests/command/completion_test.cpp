#include "command/completion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include "command/commands.hpp"
#include "says.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::completion_test {
namespace {

using Words = std::vector<std::string>;

const ProgramDescription& program() {
  static const ProgramDescription all = described_program("0");
  return all;
}

// What a command of the shell writes, line by line.
Words lines_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  Words lines;
  std::array<char, 512> line{};
  while (std::fgets(line.data(), line.size(), pipe.get())) {
    lines.emplace_back(line.data());
    lines.back().pop_back();
  }
  return lines;
}

class BashCompletion : public ::testing::Test {
 protected:
  BashCompletion() : script(folder.written("script", bash_completion(program()))) {
    folder.written("a.aem", "");
    folder.written("b c.tle", "");
  }
  // What bash offers in this folder for the last of some words after vectrix, sorted; for each of the lines.
  [[nodiscard]] std::vector<Words> all_offered(const std::vector<Words>& lines) const {
    std::string text = "source ./script\n";
    for (const Words& words : lines) {
      text += "COMP_WORDS=(vectrix";
      for (const std::string& word : words) text += " '" + word + '\'';
      text += ")\nCOMP_CWORD=" + std::to_string(words.size()) +
              "\n_vectrix\nprintf '%s\\n' \"${COMPREPLY[@]}\" end\n";
    }
    folder.written(".drive", text);
    std::vector<Words> all(1);
    for (const std::string& line : lines_of("cd '" + folder.file("").string() + "' && bash ./.drive")) {
      if (line == "end") {
        std::sort(all.back().begin(), all.back().end());
        all.emplace_back();
      } else if (!line.empty() && line != ".drive") {
        all.back().push_back(line);
      }
    }
    all.pop_back();
    EXPECT_EQ(all.size(), lines.size());
    return all;
  }
  [[nodiscard]] Words offered(const Words& words) const { return all_offered({words}).at(0); }

  TemporaryFolder folder;
  std::filesystem::path script;
  const Words files{"a.aem", "b c.tle", "script"};
};

TEST_F(BashCompletion, OffersCommands) {
  EXPECT_EQ(offered({""}), (Words{"--help", "--version", "check", "completion", "convert", "frames", "man",
                                  "pointing", "replay", "report"}));
  EXPECT_EQ(offered({"co"}), (Words{"completion", "convert"}));
  EXPECT_EQ(offered({"nothing", ""}), Words{});
}

TEST_F(BashCompletion, OffersOptions) {
  EXPECT_EQ(offered({"replay", "--"}), (Words{"--check", "--force", "--hdf5", "--help"}));
  EXPECT_EQ(offered({"pointing", "a.aem", "--ri"}), Words{"--right-ascension"});
  EXPECT_EQ(offered({"check", "--require"}), Words{});
}

TEST_F(BashCompletion, OffersTheValuesOfAnOption) {
  EXPECT_EQ(offered({"check", "--scale", "t"}), (Words{"tai", "tdb", "tt"}));
  EXPECT_EQ(offered({"check", "--scale", "=", "t"}), (Words{"tai", "tdb", "tt"}));
  EXPECT_EQ(offered({"check", "--scalar", "="}), (Words{"first", "last"}));
  EXPECT_EQ(offered({"pointing", "--target", "st"}), (Words{"star", "station"}));
  EXPECT_EQ(offered({"check", "--segment", ""}), Words{});
}

TEST_F(BashCompletion, OffersFiles) {
  EXPECT_EQ(offered({"check", ""}), files);
  EXPECT_EQ(offered({"check", "--tle", ""}), files);
  EXPECT_EQ(offered({"check", "--tle", "=", "b"}), Words{"b c.tle"});
  EXPECT_EQ(offered({"check", "--tle", "="}), files);
}

TEST_F(BashCompletion, KnowsWhichArgumentComesNext) {
  EXPECT_EQ(offered({"convert", "a.aem", ""}), files);
  EXPECT_EQ(offered({"convert", "--body", "SC", "--unit", "=", "km", "--force", "a.aem", ""}), files);
  const Words options = offered({"convert", "--"});
  EXPECT_EQ(offered({"convert", "a.aem", "--body", "SC", "out.aem", ""}), options);
  EXPECT_EQ(offered({"completion", ""}), (Words{"bash", "zsh"}));
  EXPECT_EQ(offered({"man", "vectrix-"}), Words{"vectrix-scenario.5"});
}

TEST_F(BashCompletion, KnowsEveryOption) {
  std::vector<Words> lines, expected;
  for (const CommandDescription& command : program().commands) {
    Words names;
    for (const OptionDescription& option : command.options) {
      if (option.is_argument()) continue;
      names.push_back(option.name);
      if (option.value.empty()) continue;
      lines.push_back({command.name, option.name, ""});
      expected.push_back(option.is_file() ? files : option.choices);
    }
    lines.push_back({command.name, "--"});
    expected.push_back(names);
  }
  ASSERT_FALSE(lines.empty());
  const auto found = all_offered(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::sort(expected[i].begin(), expected[i].end());
    EXPECT_EQ(found.at(i), expected[i]) << ::testing::PrintToString(lines[i]);
  }
}

TEST(ZshCompletion, QuotesWhatItsFunctionsUse) {
  const CommandDescription command{"go",
                                   "it's: [so]",
                                   "",
                                   {{"--to", "in [output]: a\\b", "Options", "FILE"},
                                    {"--how", "", "Options", "a|b", {"a", "b"}},
                                    {"--force", "", "Options", ""},
                                    {"at", "", "Options", "TIME"}}};
  const std::string script = zsh_completion({"0", {"", "", "", {}}, {command}});
  EXPECT_TRUE(says(script, "'go:it'\\''s\\: \\[so\\]'\n"));
  EXPECT_TRUE(says(script, "'--to=[in \\[output\\]\\: a\\\\b]:FILE:_files'"));
  EXPECT_TRUE(says(script, "'--how=[]:a|b:(a b)'"));
  EXPECT_TRUE(says(script, "'--force[]'"));
  EXPECT_TRUE(says(script, "':at: '"));
}

TEST(ZshCompletion, IsAScript) {
  TemporaryFolder folder;
  const auto script = folder.written("_vectrix", zsh_completion(program()));
  EXPECT_EQ(lines_of("zsh -n '" + script.string() + "' 2>&1 && echo right"), Words{"right"});
}

}  // namespace
}  // namespace vectrix::cli::completion_test

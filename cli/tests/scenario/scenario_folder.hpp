#pragma once

#include <gtest/gtest.h>

#include <string>

#include "scenario/scenario.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli {

/// The text with one part, which it must hold, replaced by another.
inline std::string with(std::string text, const std::string& part, const std::string& other) {
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << "'" << part << "' is not in:\n" << text;
  return at == std::string::npos ? text : text.replace(at, part.size(), other);
}

/// A folder with a scenario, and the table of an attitude that it reads.
class ScenarioFolder {
 public:
  ScenarioFolder() {
    folder.written(
        "a.csv",
        "t,a,b,c,d,wx,wy,wz\n2026-11-29T00:00:00,0,0,0,1,0,0,0\n2026-11-29T00:00:10,0,0,0.1,0.99,0,0,0.02\n"
        "2026-11-29T00:00:20,0,0,0.2,0.98,0,0,0.02\n");
    folder.written("t.tle", "");
  }

  static constexpr const char* plain = R"(version = 1
title = "T"
[attitude]
file = "a.csv"
time = { column = "t", scale = "UTC" }
[attitude.quaternion]
columns = ["a", "b", "c", "d"]
scalar = "last"
maps = { from = "body", to = "GCRF" }
[[measure]]
name = "off-Sun"
axis = "z of body"
target = "sun"
correction = "geometric"
[[require]]
measure = "off-Sun"
absolute = "0.5 deg"
percent = "95 %"
)";

  [[nodiscard]] std::filesystem::path file() const { return folder.file("s.toml"); }
  /// Of the scenario with this text.
  [[nodiscard]] Scenario read(const std::string& text) const {
    return read_scenario(folder.written("s.toml", text));
  }
  /// What is said of the text; FILE stands for the name of the scenario.
  [[nodiscard]] std::string refusal(const std::string& text) const {
    return complaint([&] { (void)read(text); }, file());
  }
  /// Of the plain one with one part replaced by another.
  [[nodiscard]] std::string refusal(const std::string& part, const std::string& other) const {
    return refusal(with(plain, part, other));
  }
  /// With some lines more.
  [[nodiscard]] std::string refusal_with(const std::string& lines) const { return refusal(plain + lines); }

  TemporaryFolder folder;
};

}  // namespace vectrix::cli

#pragma once

#include "check.hpp"
#include "command/description.hpp"
#include "convert.hpp"
#include "frames.hpp"
#include "pointing.hpp"
#include "replay.hpp"
#include "stored_report.hpp"
#include "target_words.hpp"
#include "words.hpp"

namespace CLI {
class App;
}

namespace vectrix::cli {

struct CheckWords {
  AttitudeWords attitude;
  InterpolationWords interpolation;
  TargetWords target;
  CheckOptions options;
};
struct PointingWords {
  AttitudeWords attitude;
  InterpolationWords interpolation;
  TargetWords target;
  PointingOptions options;
  std::string correction, when;
};
struct ConvertWords {
  AttitudeWords attitude;
  OrbitWords orbit;
  MessageWords message;
  std::string kind, step;  // of a combined message; of an orbit that has no samples, s
  ConvertOptions options;
};

/// What the options of every command say.
struct CommandWords {
  CheckWords check;
  PointingWords pointing;
  ConvertWords convert;
  ReplayOptions replay;
  FramesOptions frames;
  StoredReportOptions report;
  bool of_result = false;             // of schema
  std::string shell, manual, folder;  // of completion, man and pages
};

/// The commands, and the words that their options fill. Nothing is run.
void add_commands(CLI::App& app, CommandWords& words, const std::string& version);
/// What the manual, the completions and the reference say.
ProgramDescription described_program(const std::string& version);

}  // namespace vectrix::cli

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <exception>
#include <iostream>

#include "command/commands.hpp"
#include "command/completion.hpp"
#include "command/pages.hpp"
#include "new_file.hpp"
#include "plain_words.hpp"
#include "result_file/schema.hpp"
#include "scenario/schema.hpp"

namespace {

using namespace vectrix;
using namespace vectrix::cli;

constexpr int yes = 0, no = 1, bad_input = 2;

void require_texts(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& text : option->results())
      if (text.empty()) throw BadInput(option->get_name() + " is empty");
}

// As a message has it: 2026-11-29T00:00:00.
std::string now() {
  const std::time_t seconds = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", std::gmtime(&seconds));
  return text;
}

// Of the messages that name types: of an orbit, or else of the attitude.
std::string place_of(const AttitudeWords& attitude, const OrbitSource& orbit) {
  if (!orbit.message.empty()) return orbit.message.string();
  if (!orbit.kernel.empty()) return orbit.kernel.string();
  return orbit.elements.empty() ? attitude.file.string() : orbit.elements.string();
}

bool run_check(CheckWords& words) {
  set_interpolation(words.options.orbit, words.interpolation);
  words.options.attitude = attitude_source(words.attitude);
  if (!words.target.axis.empty()) words.options.axis = axis_of(words.target.axis);
  if (!words.target.target.empty()) words.options.target = std::get<Target>(target_of(words.target));
  return in_plain_words(place_of(words.attitude, words.options.orbit),
                        [&] { return check(words.options, std::cout); });
}

bool run_pointing(PointingWords& words) {
  set_interpolation(words.options.orbit, words.interpolation);
  words.options.attitude = attitude_source(words.attitude);
  words.options.axis = axis_of(words.target.axis);
  words.options.target = target_of(words.target);
  if (!words.correction.empty()) words.options.correction = corrections().at(words.correction);
  return in_plain_words(place_of(words.attitude, words.options.orbit),
                        [&] { return pointing(words.options, std::cout); });
}

bool run_convert(ConvertWords& words) {
  words.options.text.creation_date = now();
  const bool of_orbit = is_orbit(words.attitude, words.orbit);
  set_message_words(words.options, words.message, of_orbit);
  if (of_orbit) {
    convert(orbit_file(words.attitude, words.orbit), words.options, std::cout);
  } else {
    convert(attitude_source(words.attitude), words.options, std::cout);
  }
  return true;
}

bool run_replay(ReplayOptions& options) {
  options.version = VECTRIX_VERSION;
  Progress progress(isatty(STDERR_FILENO) != 0 ? &std::cerr : nullptr);
  return replay(options, progress, std::cout);
}

bool run_frames(const FramesOptions& options) {
  frames(options, std::cout);
  return true;
}

bool run_report(const StoredReportOptions& options) {
  stored_report(options, std::cout);
  return true;
}

bool write_pages(const std::filesystem::path& folder) {
  for (const CommandDescription& command : described_program(VECTRIX_VERSION).commands)
    write_new(folder / page_name(command), command_page(command), true);
  return true;
}

bool run(const std::string& command, CommandWords& words) {
  if (command == "check") return run_check(words.check);
  if (command == "pointing") return run_pointing(words.pointing);
  if (command == "convert") return run_convert(words.convert);
  if (command == "replay") return run_replay(words.replay);
  if (command == "report") return run_report(words.report);
  if (command == "frames") return run_frames(words.frames);
  if (command == "pages") return write_pages(words.folder);
  const auto program = described_program(VECTRIX_VERSION);
  if (command == "completion") {
    std::cout << (words.shell == "bash" ? bash_completion(program) : zsh_completion(program));
  } else if (command == "man") {
    std::cout << (words.manual == "vectrix.1" ? program_manual(program) : scenario_manual(VECTRIX_VERSION));
  } else {
    std::cout << (words.of_result ? result_page() : schema_page());
  }
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app;
  CommandWords words;
  try {
    add_commands(app, words, VECTRIX_VERSION);
    app.parse(count, arguments);
    const CLI::App& command = *app.get_subcommands().front();
    require_texts(command);
    return run(command.get_name(), words) ? yes : no;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  } catch (const std::exception& error) {
    std::cerr << "vectrix: " << error.what() << '\n';
    return bad_input;
  }
}

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string_view>
#include <system_error>

#include <vectrix/kinematics/named/nearest_name.hpp>

#include "command/commands.hpp"
#include "command/completion.hpp"
#include "command/pages.hpp"
#include "new_file.hpp"
#include "plain_words.hpp"
#include "result_file/schema.hpp"
#include "scenario/schema.hpp"
#include "table_text.hpp"

namespace {

using namespace vectrix;
using namespace vectrix::cli;

constexpr int yes = 0, no = 1, bad_input = 2;

void require_texts(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& text : option->results())
      if (text.empty()) throw BadInput(option->get_name() + " is empty");
}

// The files that are read: no directories, and no pipes where the beginning tells the format, or what is read
// next is elsewhere in the file.
void require_files(const CLI::App& command) {
  const bool is_of_scenario = command.get_name() == "replay" || command.get_name() == "frames";
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->get_type_name() != "FILE" || name == "out" || name == "--csv" || name == "--hdf5" ||
        name == "--output")
      continue;
    const bool is_read_once = name == "file"
                                  ? is_of_scenario
                                  : name != "--tle" && name != "--omm" && name != "--oem" && name != "--spk";
    for (const std::string& text : option->results()) {
      std::error_code none;
      const auto status = std::filesystem::status(text, none);
      if (std::filesystem::is_directory(status)) throw BadInput(text + ": is a directory, not a file");
      if (std::filesystem::is_fifo(status) && !is_read_once)
        throw BadInput(text + ": is a pipe, which can be read only once; write it to a file first");
    }
  }
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
  if (!orbit.mean_elements.empty()) return orbit.mean_elements.string();
  return orbit.elements.empty() ? attitude.file.string() : orbit.elements.string();
}

bool run_check(CheckWords& words) {
  set_orbit_words(words.options.orbit, words.interpolation);
  words.options.attitude = attitude_source(words.attitude);
  if (!words.target.axis.empty()) words.options.axis = axis_of(words.target.axis);
  if (!words.target.target.empty()) words.options.target = std::get<Target>(target_of(words.target));
  return in_plain_words(place_of(words.attitude, words.options.orbit),
                        [&] { return check(words.options, std::cout); });
}

bool run_pointing(PointingWords& words) {
  set_orbit_words(words.options.orbit, words.interpolation);
  words.options.attitude = attitude_source(words.attitude);
  words.options.axis = axis_of(words.target.axis);
  words.options.target = target_of(words.target);
  if (!words.correction.empty()) words.options.correction = corrections().at(words.correction);
  if (!words.when.empty()) words.options.when = when_of(words.when);
  return in_plain_words(place_of(words.attitude, words.options.orbit),
                        [&] { return pointing(words.options, std::cout); });
}

bool run_convert(ConvertWords& words) {
  words.options.text.creation_date = now();
  const Content content = content_of(words.attitude, words.orbit, words.kind, words.options.out, words.step);
  std::optional<SampledOrbit> sampled;
  if (content.kind == Content::Kind::sampled)
    sampled = sampled_orbit_of(words.attitude, words.orbit, words.options, words.step);
  const bool of_orbit = sampled || content.kind == Content::Kind::orbit;
  if (content.kind != Content::Kind::elements) set_message_words(words.options, words.message, of_orbit);
  if (content.kind == Content::Kind::elements) {
    const auto file = element_file(words.attitude, words.orbit, words.options, words.message);
    convert(file, words.options, std::cout);
  } else if (sampled) {
    convert(*sampled, words.options, std::cout);
  } else if (of_orbit) {
    convert(orbit_file(words.attitude, words.orbit), words.options, std::cout);
  } else {
    const bool writes_kernel = is_kernel_name(words.options.out);
    if (writes_kernel) words.options.kernel = words.attitude.kernel;
    convert(attitude_source(words.attitude, writes_kernel), words.options, std::cout);
  }
  if (!content.left_out.empty())
    std::cout << "  left out of the combined message: " << content.left_out << '\n';
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

// What to write instead of a command or an option that does not exist: "" if nothing is near.
std::string nearest_to(const CLI::App& app, int count, char** arguments) {
  std::vector<std::string> names;
  const auto parsed = app.get_subcommands();
  if (parsed.empty()) {
    for (const CLI::App* const each : app.get_subcommands([](const CLI::App*) { return true; }))
      if (!each->get_group().empty()) names.push_back(each->get_name());
  } else {
    for (const CLI::Option* const option : parsed.front()->get_options())
      for (const std::string& name : option->get_lnames())
        if (name != "help") names.push_back("--" + name);
  }
  for (int i = 1; i < count; ++i) {
    const std::string word = std::string(arguments[i]).substr(0, std::string_view(arguments[i]).find('='));
    const bool is_option = word.starts_with("--");
    if (is_option == parsed.empty() || std::find(names.begin(), names.end(), word) != names.end()) continue;
    const std::string_view nearest = detail::nearest_name(word, names);
    if (!nearest.empty()) return "'" + word + "' is unknown; the nearest is '" + std::string(nearest) + "'\n";
    if (parsed.empty()) break;
  }
  return "";
}

// What was written may still be on its way: a full disk shows here.
int written(int code) {
  if (std::cout.flush()) return code;
  std::cerr << "vectrix: the standard output cannot be written; is the disk full?\n";
  return bad_input;
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
    require_files(command);
    return written(run(command.get_name(), words) ? yes : no);
  } catch (const CLI::ParseError& error) {
    if (app.exit(error) == 0) return written(yes);
    std::cerr << nearest_to(app, count, arguments);
    return bad_input;
  } catch (const std::exception& error) {
    std::cerr << "vectrix: " << error.what() << '\n';
    return bad_input;
  }
}

#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vectrix::cli {

/// An option of a command; or, if its name has no dashes, an argument, in its place.
struct OptionDescription {
  std::string name, help, group;
  std::string value;                   // what follows an option: "FILE", "first|last"; empty: nothing
  std::vector<std::string> choices{};  // all values, if there is a list of them
  bool is_needed = false;

  [[nodiscard]] bool is_argument() const { return name.front() != '-'; }
  [[nodiscard]] bool is_file() const { return value == "FILE"; }
};

struct CommandDescription {
  std::string name, help;
  std::string notes;  // paragraphs; lines that are indented stay as they are
  std::vector<OptionDescription> options;

  /// The titles of the groups of options, each once, in their order.
  [[nodiscard]] std::vector<std::string> groups() const;
};

/// The program as its parser has it, without what is hidden: completions, manual and reference come from it.
struct ProgramDescription {
  std::string version;
  CommandDescription itself;
  std::vector<CommandDescription> commands;
};
ProgramDescription described(const CLI::App& app, const std::string& version);

/// "file out [options]": what stands after the name of the command.
std::string usage_of(const CommandDescription& command);

/// Begun with a capital letter and ended with a full stop.
std::string sentence(std::string text);

/// A paragraph of notes, without the breaks of its lines unless it is indented.
struct Paragraph {
  std::vector<std::string> lines;
  bool is_indented;
};
std::vector<Paragraph> paragraphs(const std::string& notes);

}  // namespace vectrix::cli

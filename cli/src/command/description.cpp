#include "command/description.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

namespace vectrix::cli {
namespace {

OptionDescription option_of(const CLI::Option& option) {
  OptionDescription made;
  made.name = option.get_lnames().empty() ? option.get_name() : "--" + option.get_lnames().front();
  made.help = option.get_description();
  made.group = option.get_group();
  made.is_needed = option.get_required();
  if (option.get_items_expected_max() == 0) return made;  // a flag
  made.value = option.get_type_name();
  if (made.value.find('|') == std::string::npos) return made;
  std::istringstream in(made.value);
  for (std::string each; std::getline(in, each, '|');) made.choices.push_back(each);
  return made;
}

CommandDescription command_of(const CLI::App& app) {
  CommandDescription made{app.get_name(), app.get_description(), app.get_footer(), {}};
  for (const CLI::Option* const option : app.get_options())
    if (!option->get_group().empty()) made.options.push_back(option_of(*option));
  return made;
}

}  // namespace

std::vector<std::string> CommandDescription::groups() const {
  std::vector<std::string> all;
  for (const OptionDescription& option : options)
    if (std::find(all.begin(), all.end(), option.group) == all.end()) all.push_back(option.group);
  return all;
}

ProgramDescription described(const CLI::App& app, const std::string& version) {
  ProgramDescription made{version, command_of(app), {}};
  for (const CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) made.commands.push_back(command_of(*command));
  return made;
}

std::string usage_of(const CommandDescription& command) {
  std::string usage;
  for (const OptionDescription& option : command.options)
    if (option.is_argument()) usage += (option.choices.empty() ? option.name : option.value) + ' ';
  return usage + "[options]";
}

std::string sentence(std::string text) {
  if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text + '.';
}

std::vector<Paragraph> paragraphs(const std::string& notes) {
  std::vector<Paragraph> all;
  bool is_new = true;
  std::istringstream in(notes);
  for (std::string line; std::getline(in, line); is_new = line.empty()) {
    if (line.empty()) continue;
    const bool is_indented = line.front() == ' ';
    if (is_new || is_indented != all.back().is_indented) all.push_back({{}, is_indented});
    all.back().lines.push_back(line.substr(is_indented ? 2 : 0));
  }
  return all;
}

}  // namespace vectrix::cli

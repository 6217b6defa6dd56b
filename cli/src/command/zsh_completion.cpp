#include "command/completion.hpp"

namespace vectrix::cli {
namespace {

// Within single quotes, where _arguments and _describe give brackets and colons a meaning.
std::string in_quotes(const std::string& text) {
  std::string all;
  for (const char c : text) {
    if (c == '\'') {
      all += "'\\'";
    } else if (c == '[' || c == ']' || c == ':' || c == '\\') {
      all += '\\';
    }
    all += c;
  }
  return all;
}

// What may be written for it: ":first|last:(first last)".
std::string value_of(const OptionDescription& option) {
  std::string action = option.is_file() ? "_files" : " ";
  if (!option.choices.empty()) {
    action.clear();
    for (const std::string& choice : option.choices) action += (action.empty() ? "(" : " ") + choice;
    action += ')';
  }
  return ':' + in_quotes(option.is_argument() ? option.name : option.value) + ':' + action;
}

std::string argument_of(const OptionDescription& option) {
  if (option.is_argument()) return value_of(option);
  const bool is_flag = option.value.empty();
  return (option.name == "--help" || option.name == "--version" ? "(- *)" : "") + option.name +
         (is_flag ? "" : "=") + '[' + in_quotes(option.help) + ']' + (is_flag ? "" : value_of(option));
}

std::string arguments_of(const CommandDescription& command, const std::string& indented) {
  std::string text;
  for (const OptionDescription& option : command.options)
    text += " \\\n" + indented + '\'' + argument_of(option) + '\'';
  return text;
}

}  // namespace

std::string zsh_completion(const ProgramDescription& program) {
  std::string text =
      "#compdef vectrix\n# The completion of vectrix for zsh, written by: vectrix completion zsh\n"
      "_vectrix() {\n  local context state state_descr line\n  local -A opt_args\n  local -a commands\n"
      "  commands=(\n";
  for (const CommandDescription& command : program.commands)
    text += "    '" + command.name + ':' + in_quotes(command.help) + "'\n";
  text += "  )\n  _arguments -C" + arguments_of(program.itself, "    ") +
          " \\\n    '1:command:->command' \\\n    '*::argument:->argument'\n"
          "  case $state in\n    command) _describe command commands ;;\n    argument)\n"
          "      case $words[1] in\n";
  for (const CommandDescription& command : program.commands)
    text += "        " + command.name + ")\n          _arguments" + arguments_of(command, "            ") +
            "\n          ;;\n";
  return text +
         "      esac\n      ;;\n  esac\n}\n"
         "if [[ $funcstack[1] == _vectrix ]]; then\n  _vectrix \"$@\"\nelse\n  compdef _vectrix "
         "vectrix\nfi\n";
}

}  // namespace vectrix::cli

#include "command/completion.hpp"
#include "word.hpp"

namespace vectrix::cli {
namespace {

constexpr const char* before_commands =
    R"(# The completion of vectrix for bash, written by: vectrix completion bash
_vectrix() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} i place=0
  local options='' with_value='' files='' values='' arguments=()
  # --option=value is three words here.
  if [[ $word == '=' ]]; then
    word=''
  elif [[ $before == '=' ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  COMPREPLY=()
)";

constexpr const char* after_commands = R"(    *) return ;;
  esac
  if [[ " $with_value " == *" $before "* ]]; then
    [[ " $files " != *" $before "* ]] || values=FILE
  elif [[ $word == -* ]]; then
    values=$options
  else
    for ((i = 2; i < COMP_CWORD; ++i)); do
      if [[ " $with_value " == *" ${COMP_WORDS[i]} "* ]]; then
        ((++i))
        [[ ${COMP_WORDS[i]} != '=' ]] || ((++i))
      elif [[ ${COMP_WORDS[i]} != -* ]]; then
        ((++place))
      fi
    done
    values=${arguments[place]:-$options}
  fi
  if [[ $values == FILE ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
    compopt -o filenames -o default 2>/dev/null  # where no file is found, bash looks itself: ~ and quotes
  else
    mapfile -t COMPREPLY < <(compgen -W "$values" -- "$word")
  fi
}
complete -F _vectrix vectrix
)";

std::vector<std::string> option_names(const CommandDescription& command) {
  std::vector<std::string> names;
  for (const OptionDescription& option : command.options)
    if (!option.is_argument()) names.push_back(option.name);
  return names;
}

std::string of_command(const CommandDescription& command) {
  std::vector<std::string> with_value, files;
  std::string arguments, choices;
  for (const OptionDescription& option : command.options) {
    const std::string values = option.is_file() ? "FILE" : joined(option.choices, " ");
    if (option.is_argument()) {
      arguments += (arguments.empty() ? "'" : " '") + values + '\'';
    } else if (!option.value.empty()) {
      with_value.push_back(option.name);
      if (option.is_file()) files.push_back(option.name);
      if (!option.choices.empty()) choices += "        " + option.name + ") values='" + values + "' ;;\n";
    }
  }
  std::string text = "    " + command.name + ")\n      options='" + joined(option_names(command), " ") +
                     "'\n      with_value='" + joined(with_value, " ") + "'\n      files='" +
                     joined(files, " ") + "'\n      arguments=(" + arguments + ")\n";
  if (!choices.empty()) text += "      case $before in\n" + choices + "      esac\n";
  return text + "      ;;\n";
}

}  // namespace

std::string bash_completion(const ProgramDescription& program) {
  std::vector<std::string> first;
  for (const CommandDescription& command : program.commands) first.push_back(command.name);
  for (const std::string& name : option_names(program.itself)) first.push_back(name);
  std::string text = std::string(before_commands) +
                     "  if ((COMP_CWORD == 1)); then\n    mapfile -t COMPREPLY < <(compgen -W '" +
                     joined(first, " ") + "' -- \"$word\")\n    return\n  fi\n  case ${COMP_WORDS[1]} in\n";
  for (const CommandDescription& command : program.commands) text += of_command(command);
  return text + after_commands;
}

}  // namespace vectrix::cli

#include "command/pages.hpp"

namespace vectrix::cli {
namespace {

// In a cell of a table.
std::string cell(const std::string& text) {
  std::string all;
  for (const char c : text) {
    if (c == '|') all += '\\';
    all += c;
  }
  return all;
}

std::string as_code(const std::string& text) {
  return text.empty() ? "" : '`' + cell(text) + '`';
}

}  // namespace

std::string page_name(const CommandDescription& command) {
  return "vectrix_" + command.name + ".md";
}

std::string command_page(const CommandDescription& command) {
  std::string page =
      "# vectrix " + command.name + "\n\n" + sentence(command.help) +
      " This page is written by `./dev docs` from the description\nwith which the program reads "
      "its options; `vectrix " +
      command.name + " --help` says the same.\n\n    vectrix " + command.name + ' ' + usage_of(command) +
      '\n';
  for (const std::string& group : command.groups()) {
    page += "\n## " + group + "\n\n| option | value | needed | meaning |\n| --- | --- | --- | --- |\n";
    for (const OptionDescription& option : command.options)
      if (option.group == group)
        page += "| `" + option.name + "` | " + as_code(option.value) + " | " +
                (option.is_needed ? "yes" : "") + " | " + cell(option.help) + " |\n";
  }
  page += "\n## Notes\n";
  for (const Paragraph& each : paragraphs(command.notes)) {
    page += '\n';
    for (const std::string& line : each.lines) page += (each.is_indented ? "    " : "") + line + '\n';
  }
  return page;
}

}  // namespace vectrix::cli

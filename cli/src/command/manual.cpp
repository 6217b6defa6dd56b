#include "command/pages.hpp"
#include "scenario/schema.hpp"

namespace vectrix::cli {
namespace {

// As text of troff; what stands in `these` becomes bold.
std::string roff(const std::string& text) {
  std::string all;
  bool is_bold = false;
  for (const char c : text) {
    if (c == '`') {
      is_bold = !is_bold;
      all += is_bold ? "\\fB" : "\\fR";
    } else if (c == '\\') {
      all += "\\e";
    } else if (c == '-') {
      all += "\\-";
    } else if (c == '\'') {
      all += "\\(aq";
    } else {
      if (c == '.' && all.empty()) all += "\\&";
      all += c;
    }
  }
  return all;
}
std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}
std::string italic(const std::string& text) {
  return "\\fI" + roff(text) + "\\fR";
}

std::string title(const char* name, const char* section, const std::string& version, const char* manual) {
  return std::string(".TH ") + name + ' ' + section + " \"\" \"vectrix " + version + "\" \"" + manual +
         "\"\n";
}

// A term, and below it what it means.
std::string item(const std::string& term, const std::string& meaning) {
  return ".TP\n" + term + '\n' + roff(meaning) + '\n';
}

std::string options_of(const CommandDescription& command) {
  std::string text;
  for (const std::string& group : command.groups()) {
    if (group != "Options") text += ".PP\n" + roff(group) + ":\n";
    for (const OptionDescription& option : command.options) {
      if (option.group != group) continue;
      const std::string value = option.value.empty() ? "" : ' ' + italic(option.value);
      text += item(option.is_argument() ? italic(option.name) : bold(option.name) + value,
                   option.help + (option.is_needed ? " (needed)" : ""));
    }
  }
  return text;
}

std::string notes_of(const CommandDescription& command) {
  std::string text;
  for (const Paragraph& each : paragraphs(command.notes)) {
    text += each.is_indented ? ".PP\n.RS\n.nf\n" : ".PP\n";
    for (const std::string& line : each.lines) text += roff(line) + '\n';
    if (each.is_indented) text += ".fi\n.RE\n";
  }
  return text;
}

std::string item(const Key& key, const std::string& before) {
  return item(bold(before + key.name) + (key.needed ? " (needed)" : ""), form_of(key) + ": " + key.help);
}
std::string keys_of(const Key& table, const std::string& before) {
  std::string text;
  for (const Key& key : table.keys) {
    text += item(key, before);
    if (key.kind == Kind::table) text += keys_of(key, before + key.name + '.');
  }
  return text;
}

}  // namespace

std::string program_manual(const ProgramDescription& program) {
  std::string text = title("VECTRIX", "1", program.version, "User Commands") + ".SH NAME\nvectrix \\- " +
                     roff(program.itself.help) +
                     "\n.SH SYNOPSIS\n.B vectrix\n.I command\n[options]\n.SH OPTIONS\n" +
                     options_of(program.itself) + ".SH COMMANDS\n";
  for (const CommandDescription& command : program.commands)
    text += ".SS vectrix " + roff(command.name + ' ' + usage_of(command)) + '\n' +
            roff(sentence(command.help)) + '\n' + notes_of(command) + options_of(command);
  return text + ".SH SEE ALSO\n.BR vectrix\\-scenario (5)\n";
}

std::string scenario_manual(const std::string& version) {
  std::string text = title("VECTRIX\\-SCENARIO", "5", version, "File Formats") +
                     ".SH NAME\nvectrix\\-scenario \\- the scenario file of vectrix\n.SH DESCRIPTION\n";
  for (const std::string& rule : schema_rules()) text += ".PP\n" + roff(rule) + '\n';
  text += ".SH KEYS AT THE TOP\n";
  for (const Key& key : schema().keys)
    if (!is_section(key)) text += item(key, "");
  for (const Key& key : schema().keys)
    if (is_section(key))
      text += ".SH " + roff(name_of_section(key)) + '\n' + roff(meaning_of_section(key)) + '\n' +
              keys_of(key, "");
  return text + ".SH SEE ALSO\n.BR vectrix (1)\n";
}

}  // namespace vectrix::cli

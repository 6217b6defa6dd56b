#include "scenario/schema.hpp"

namespace vectrix::cli {
namespace {

void add_rows(std::string& page, const Key& of, const std::string& before) {
  for (const Key& key : of.keys) {
    page += "| `" + before + key.name + "` | " + (key.needed ? "yes" : "") + " | " + form_of(key) + " | " +
            key.help + " |\n";
    if (key.kind == Kind::table) add_rows(page, key, before + key.name + ".");
  }
}

}  // namespace

bool is_section(const Key& key) {
  return key.kind == Kind::table || key.kind == Kind::tables;
}

std::string name_of_section(const Key& key) {
  return key.kind == Kind::tables ? "[[" + key.name + "]]" : "[" + key.name + "]";
}

std::string meaning_of_section(const Key& key) {
  const char* const how = key.kind == Kind::tables ? "Any number of them: "
                          : key.needed             ? "Needed: "
                                                   : "Optional: ";
  return how + key.help + ".";
}

const std::vector<std::string>& schema_rules() {
  static const std::vector<std::string> rules{
      "A quantity is a text with its unit, `\"0.5 deg\"`. A bare number is refused where a unit is needed.",
      "Names of frames: `J2000` and `EME2000` are one, `ICRF` and `GCRF` too; others are those of the file.",
      "Files that are read are named relative to the file in which their name stands.",
      "An unknown key is refused, and so are NaN and infinity. Messages begin with `file:line:column`."};
  return rules;
}

std::string schema_page() {
  std::string page =
      "# The scenario file\n\n"
      "`vectrix replay file.toml` reads a flight and says whether it fulfils what is required. The file is "
      "TOML 1.0.\n"
      "This page is written by `./dev docs` from the description with which the program reads the file;\n"
      "[the tutorial](../tutorial/4_from_an_attitude_file_to_a_verdict.md) shows one being made.\n\n";
  for (const std::string& rule : schema_rules()) page += "- " + rule + '\n';
  page += "\n## Keys at the top\n\n| key | needed | form | meaning |\n| --- | --- | --- | --- |\n";
  for (const Key& key : schema().keys) {
    if (is_section(key)) continue;
    page += "| `" + key.name + "` | " + (key.needed ? "yes" : "") + " | " + form_of(key) + " | " + key.help +
            " |\n";
  }
  for (const Key& key : schema().keys) {
    if (!is_section(key)) continue;
    page += "\n## " + name_of_section(key) + "\n\n" + meaning_of_section(key) +
            "\n\n| key | needed | form | meaning |\n| --- | --- | --- | --- |\n";
    add_rows(page, key, "");
  }
  return page;
}

}  // namespace vectrix::cli

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

bool is_section(const Key& key) {
  return key.kind == Kind::table || key.kind == Kind::tables;
}

}  // namespace

std::string schema_page() {
  std::string page =
      "# The scenario file\n\n"
      "`vectrix replay file.toml` reads a flight and says whether it fulfils what is required. The file is "
      "TOML 1.0.\n"
      "This page is written by `./dev docs` from the description with which the program reads the file;\n"
      "[the tutorial](../tutorial/4_from_an_attitude_file_to_a_verdict.md) shows one being made.\n\n"
      "- A quantity is a text with its unit, `\"0.5 deg\"`. A bare number is refused where a unit is "
      "needed.\n"
      "- Names of frames: `J2000` and `EME2000` are one, `ICRF` and `GCRF` too; others are those of the "
      "file.\n"
      "- Files that are read are named relative to the file in which their name stands.\n"
      "- An unknown key is refused, and so are NaN and infinity. Messages begin with `file:line:column`.\n\n"
      "## Keys at the top\n\n"
      "| key | needed | form | meaning |\n| --- | --- | --- | --- |\n";
  for (const Key& key : schema().keys) {
    if (is_section(key)) continue;
    page += "| `" + key.name + "` | " + (key.needed ? "yes" : "") + " | " + form_of(key) + " | " + key.help +
            " |\n";
  }
  for (const Key& key : schema().keys) {
    if (!is_section(key)) continue;
    const bool many = key.kind == Kind::tables;
    page += "\n## " + std::string(many ? "[[" : "[") + key.name + (many ? "]]" : "]") + "\n\n" +
            (many         ? "Any number of them: "
             : key.needed ? "Needed: "
                          : "Optional: ") +
            key.help + ".\n\n" + "| key | needed | form | meaning |\n| --- | --- | --- | --- |\n";
    add_rows(page, key, "");
  }
  return page;
}

}  // namespace vectrix::cli

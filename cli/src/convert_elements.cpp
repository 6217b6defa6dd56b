#include <algorithm>
#include <fstream>
#include <ostream>
#include <set>

#include "convert.hpp"
#include "figures.hpp"
#include "message_kind.hpp"
#include "new_file.hpp"
#include "table_text.hpp"

namespace vectrix::cli {
namespace {

// What is given replaces what the message has.
OrbitMeanElementsMessage with_given(OrbitMeanElementsMessage message, const GivenText& given) {
  message = message.with("CREATION_DATE", given.creation_date);
  for (const auto& [keyword, value] : {std::pair{"OBJECT_NAME", &given.object_name},
                                       {"OBJECT_ID", &given.object_id},
                                       {"ORIGINATOR", &given.originator}})
    if (!value->empty()) message = message.with(keyword, *value);
  return message;
}

// Of two lines, which do not say who made them, and may not say of what they are.
std::vector<OrbitMeanElementsMessage> messages_of(const std::vector<TwoLineElements>& sets,
                                                  const GivenText& given, const std::string& file) {
  const bool named =
      std::all_of(sets.begin(), sets.end(), [](const auto& set) { return !set.title().empty(); });
  Words needed{{"--originator NAME", given.originator}};
  if (!named) needed.push_back({"--object-name NAME", given.object_name});
  if (const std::string missing = missing_of(needed); !missing.empty())
    throw BadInput(file + ": two lines do not say what a message needs; missing: " + missing);
  std::vector<OrbitMeanElementsMessage> messages;
  for (const TwoLineElements& set : sets)
    messages.emplace_back(MessageHeader{"2.0", given.creation_date, given.originator}, set);
  return messages;
}

}  // namespace

bool has_two_lines(const std::filesystem::path& file) {
  if (ending_of(file) == ".tle") return true;
  std::ifstream in(file);
  constexpr std::size_t columns = 68;
  constexpr int most = 2;  // line 1 of a set, or a title before it
  int count = 0;
  for (std::string line; count < most && std::getline(in, line);) {
    if (line.starts_with('#') || line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (line.starts_with("1 ") && line.size() >= columns) return true;
    ++count;
  }
  return false;
}

void convert(const ElementFile& elements, const ConvertOptions& options, std::ostream& out) {
  const std::string kind = ending_of(options.out);
  if (kind != ".omm" && kind != ".xml")
    throw BadInput(options.out.string() +
                   ": elements of SGP4 are written as .omm or .xml, and their orbit as .oem, .csv or .czml");
  refuse_input(options.out, {elements.file});
  const GivenText& given = options.text;
  require_one_line("--object-name", given.object_name);
  require_one_line("--object-id", given.object_id);
  require_one_line("--originator", given.originator);
  const bool are_lines = !is_message(elements.file);
  auto messages = are_lines ? messages_of(TwoLineElements::read(elements.file), given, elements.file.string())
                            : read_mean_elements_messages(elements.file);
  std::set<std::string> objects;
  for (OrbitMeanElementsMessage& message : messages) {
    objects.insert(message.object_id());
    message = with_given(std::move(message), given);
  }
  if (objects.size() > 1)
    refuse({{"--object-name", given.object_name}, {"--object-id", given.object_id}},
           elements.file.string() + ": it has the elements of " + counted(objects.size(), "satellite") + "; ",
           " is of one");
  write_new(options.out, OrbitMeanElementsMessage::text_of(messages, kind == ".xml"), options.force);
  out << options.out.string() << ": " << counted(messages.size(), "set") << " of elements for SGP4\n";
  if (are_lines)
    out << "  MEAN_MOTION_DOT and MEAN_MOTION_DDOT are the numbers of the lines, half of the derivative and "
           "a "
           "sixth of the second one\n";
}

}  // namespace vectrix::cli

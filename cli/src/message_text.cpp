#include "message_text.hpp"

#include <algorithm>

namespace vectrix::cli {

void require_one_line(const char* option, const std::string& text) {
  if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
    throw BadInput(std::string(option) + " holds a line break or another control character");
}

MessageText message_text(const GivenText& given, const std::optional<MessageText>& read,
                         const TimeScale& scale, const std::string& file, const Words& also_needed) {
  require_one_line("--object-name", given.object_name);
  require_one_line("--object-id", given.object_id);
  require_one_line("--originator", given.originator);
  MessageText text = read.value_or(MessageText{});
  if (!read) {
    Words needed{{"--object-name NAME", given.object_name},
                 {"--object-id ID", given.object_id},
                 {"--originator NAME", given.originator}};
    for (const Word& word : also_needed) needed.push_back(word);
    if (const std::string missing = missing_of(needed); !missing.empty())
      throw BadInput(file + ": the file does not say what a message needs; missing: " + missing);
    text.metadata.time_system = scale;
  }
  const auto set = [](std::string& value, const std::string& words) {
    if (!words.empty()) value = words;
  };
  text.header.creation_date = given.creation_date;
  set(text.header.originator, given.originator);
  set(text.metadata.object_name, given.object_name);
  set(text.metadata.object_id, given.object_id);
  return text;
}

std::string object_name(const GivenText& given, const std::optional<MessageText>& read,
                        const std::string& file) {
  require_one_line("--object-name", given.object_name);
  if (!given.object_name.empty()) return given.object_name;
  if (!read || read->metadata.object_name.empty())
    throw BadInput(file + ": the object has no name; missing: --object-name NAME");
  return read->metadata.object_name;
}

void set_times(EphemerisMetadata& metadata, const Epoch& first, const Epoch& last, const std::string& file) {
  metadata.start_time = first;
  metadata.stop_time = last;
  auto& useable_start = metadata.useable_start_time;
  auto& useable_stop = metadata.useable_stop_time;
  if (useable_start) useable_start = std::max(*useable_start, first);
  if (useable_stop) useable_stop = std::min(*useable_stop, last);
  if (useable_start.value_or(first) > useable_stop.value_or(last))
    throw BadInput(file + ": none of the times is within USEABLE_START_TIME and USEABLE_STOP_TIME");
}

}  // namespace vectrix::cli

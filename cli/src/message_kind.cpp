#include "message_kind.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include "table_text.hpp"
#include "word.hpp"

namespace vectrix::cli {
namespace {

std::string first_word(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw BadInput(file.string() + ": cannot be read");
  std::string word;
  in >> word;
  if (word.starts_with("\xef\xbb\xbf")) word.erase(0, 3);
  return word;
}

// Or the mark of UTF-16.
bool is_xml(const std::string& word) {
  const auto has_at = [&](const char* mark, std::size_t place) {
    return word.starts_with(mark) && word.size() > place && word[place] == '<';
  };
  return word.starts_with('<') || has_at("\xff\xfe", 2) || has_at("\xfe\xff", 3);
}

// The name of the first element of a file in XML, without its prefix; "" if it has none.
std::string first_element(const std::filesystem::path& file) {
  constexpr std::size_t enough = 4096;  // for comments before it
  std::string text(enough, '\0');
  text.resize(
      static_cast<std::size_t>(std::ifstream(file, std::ios::binary).read(text.data(), enough).gcount()));
  std::erase(text, '\0');  // UTF-16 of ASCII
  for (auto at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    if (text.compare(at, 4, "<!--") == 0) at = text.find("-->", at);
    if (at == std::string::npos) break;
    if (at + 1 >= text.size() || !std::isalpha(static_cast<unsigned char>(text[at + 1]))) continue;
    const std::string name = text.substr(at + 1, text.find_first_of(" \t\r\n/>", at) - at - 1);
    return name.substr(name.find(':') + 1);
  }
  return "";
}

// The kind of a message of CCSDS in small letters, "aem", or "ndm" of a combined one; else anything.
std::string kind_of_message(const std::filesystem::path& file) {
  constexpr std::string_view start = "CCSDS_";
  constexpr std::size_t letters = 3;
  const std::string word = first_word(file);
  if (word.starts_with(start)) return small(word.substr(start.size(), letters));
  return is_xml(word) ? first_element(file) : "";
}

// "OPM, 2 OMM", without one of them.
std::string kinds_in(const NavigationDataMessage& all, const std::string& but = "") {
  std::string text;
  const auto add = [&](const std::string& kind, std::size_t count) {
    if (count > 0 && kind != but)
      text += (text.empty() ? "" : ", ") + (count > 1 ? std::to_string(count) + " " : "") + capitals(kind);
  };
  add("aem", all.attitude_ephemerides.size());
  add("apm", all.attitude_parameters.size());
  add("oem", all.orbit_ephemerides.size());
  add("opm", all.orbit_parameters.size());
  add("omm", all.orbit_mean_elements.size());
  for (const UnreadMessage& each : all.unread) add(each.element, 1);
  return text.empty() && but.empty() ? "nothing" : text;
}

std::string listed(const std::vector<std::string>& kinds, const char* between) {
  std::string text;
  for (const std::string& kind : kinds) text += (text.empty() ? "" : between) + capitals(kind);
  return text;
}

// What to do with a message that no command takes.
std::string hint_of(const std::string& kind) {
  const auto of_one_instant = [&](const char* what, const char* type) {
    return "; an " + capitals(kind) + " is " + what + " at one instant, which no command takes; in C++ " +
           type + " reads it";
  };
  if (kind == "apm") return of_one_instant("an attitude", "AttitudeParameterMessage");
  if (kind == "opm") return of_one_instant("an orbit", "OrbitParameterMessage");
  return "";
}

// Of a file of another kind, if it is a kind.
void require_kind(const std::filesystem::path& file, const std::string& kind,
                  const std::vector<std::string>& wanted) {
  static const std::set<std::string> kinds{"acm", "aem", "apm", "cdm", "ocm", "oem", "omm", "opm", "tdm"};
  if (std::find(wanted.begin(), wanted.end(), kind) == wanted.end() && kinds.contains(kind))
    throw BadInput(file.string() + ": is a message of the kind " + capitals(kind) + ", not " +
                   listed(wanted, " or ") + hint_of(kind));
}

template <class Message>
Message the_one(const std::filesystem::path& file, const char* wanted,
                std::vector<Message> NavigationDataMessage::*which) {
  const std::string kind = kind_of_message(file);
  require_kind(file, kind, {wanted});
  if (kind != "ndm") return Message::read(file);
  auto all = NavigationDataMessage::read(file);
  if ((all.*which).size() != 1)
    throw BadInput(file.string() + ": is a combined message, of which one " + capitals(wanted) +
                   " is read; it has " + kinds_in(all));
  return std::move((all.*which).front());
}

}  // namespace

bool is_message(const std::filesystem::path& file) {
  const std::string word = first_word(file);
  if ((word.starts_with("\xff\xfe") || word.starts_with("\xfe\xff")) && !is_xml(word))
    throw BadInput(file.string() + ": is UTF-16, and no XML; a table or a message in keywords is UTF-8");
  return word.starts_with("CCSDS_") || is_xml(word) || word == "COMMENT";
}

void require_content(const std::filesystem::path& file) {
  if (first_word(file).empty()) throw BadInput(file.string() + ": is empty");
}

KindOfMessage kind_to_convert(const std::filesystem::path& file, const std::string& stated,
                              const std::filesystem::path& out) {
  const std::vector<std::string> known{"aem", "oem", "omm"};
  const std::string kind = kind_of_message(file);
  if (kind != "ndm") {
    if (!stated.empty()) throw BadInput(file.string() + ": is one message; --kind is of a combined one");
    require_kind(file, kind, known);
    return {kind, ""};
  }
  const auto all = NavigationDataMessage::read(file);
  const std::string has = file.string() + ": is a combined message; it has " + kinds_in(all);
  std::vector<std::string> there;
  if (!all.attitude_ephemerides.empty()) there.emplace_back("aem");
  if (!all.orbit_ephemerides.empty()) there.emplace_back("oem");
  if (!all.orbit_mean_elements.empty()) there.emplace_back("omm");
  const auto chosen = [&](const std::string& one) { return KindOfMessage{one, kinds_in(all, one)}; };
  const auto is_there = [&](const std::string& one) {
    return std::find(there.begin(), there.end(), one) != there.end();
  };
  if (there.empty()) throw BadInput(has + ", none of " + listed(known, ", "));
  if (!stated.empty()) {
    if (!is_there(stated)) throw BadInput(has + "; --kind is " + stated);
    return chosen(stated);
  }
  const std::string name = ending_of(out);
  const std::string of_name =
      name == ".bc" || name == ".a" ? "aem" : name.substr(std::min<std::size_t>(name.size(), 1));
  if (is_there(of_name)) return chosen(of_name);
  if (there.size() > 1) throw BadInput(has + "; missing: --kind " + joined(there, "|"));
  return chosen(there.front());
}

AttitudeEphemerisMessage read_attitude_message(const std::filesystem::path& file) {
  return the_one(file, "aem", &NavigationDataMessage::attitude_ephemerides);
}

OrbitEphemerisMessage read_orbit_message(const std::filesystem::path& file) {
  return the_one(file, "oem", &NavigationDataMessage::orbit_ephemerides);
}

std::vector<OrbitMeanElementsMessage> read_mean_elements_messages(const std::filesystem::path& file) {
  const std::string kind = kind_of_message(file);
  require_kind(file, kind, {"omm"});
  if (kind != "ndm") return OrbitMeanElementsMessage::read(file);
  auto all = NavigationDataMessage::read(file);
  if (all.orbit_mean_elements.empty())
    throw BadInput(file.string() + ": is a combined message without an OMM; it has " + kinds_in(all));
  return std::move(all.orbit_mean_elements);
}

}  // namespace vectrix::cli

#include "ephemeris_rules.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "../time/date.hpp"
#include "kvn.hpp"
#include "text_file.hpp"

namespace vectrix::detail {

bool MessageKind::has(const std::string& version) const {
  return std::find(versions.begin(), versions.end(), version) != versions.end();
}

std::string MessageKind::element() const {
  std::string lower{std::string_view{version_keyword}.substr(6, 3)};  // CCSDS_AEM_VERS
  for (char& c : lower) c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string MessageKind::list() const {
  std::string list;
  for (const char* version : versions) list += (list.empty() ? "" : ", ") + std::string{version};
  return list;
}

namespace {

constexpr std::string_view words[] = {"COMMENT",   "META_START",       "META_STOP",      "DATA_START",
                                      "DATA_STOP", "COVARIANCE_START", "COVARIANCE_STOP"};

// How many characters must be put in, left out or exchanged to make one text of the other.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t exchanged = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({exchanged, row[j] + 1, row[j - 1] + 1}));
    }
  }
  return row.back();
}

std::string text_of(const std::string& place, const Epoch& time, const TimeScale& scale) {
  try {
    return exact_text(time, scale);
  } catch (const BadInput& error) {
    throw BadInput(place + ": " + error.what());
  }
}

}  // namespace

std::string other_fault(const MessageKind& kind, std::string_view keyword) {
  if (keyword.starts_with("USER_DEFINED_")) return "";
  constexpr std::size_t most_of_a_slip = 2;
  std::string_view nearest;
  std::size_t fewest = most_of_a_slip + 1;
  const auto compare = [&](std::string_view known) {
    const auto [shorter, longer] = std::minmax({keyword.size(), known.size()});
    if (longer - shorter >= fewest) return;
    const std::size_t count = edits(keyword, known);
    if (count < fewest) nearest = known;
    fewest = std::min(fewest, count);
  };
  compare(kind.version_keyword);
  for (const MessageKeyword& known : kind.keywords) compare(known.name);
  for (const std::string_view word : words) compare(word);
  if (fewest == 0) return "the keyword has its place in another part of the message";
  if (fewest <= most_of_a_slip)
    return "the keyword is not of the standard, but nearly " + std::string{nearest};
  return "";
}

void require_others(const std::string& place, const MessageKind& kind,
                    const std::vector<OtherKeyword>& others) {
  for (std::size_t i = 0; i < others.size(); ++i) {
    const std::string& keyword = others[i].keyword;
    const auto fail = [&](const std::string& reason) {
      throw BadInput(place + ": '" + excerpt(keyword) + "' among the other keywords: " + reason);
    };
    if (!is_keyword(keyword)) fail("a keyword is of A-Z, 0-9 and _");
    if (const std::string fault = other_fault(kind, keyword); !fault.empty()) fail(fault);
    for (std::size_t j = 0; j < i; ++j) {
      if (others[j].keyword == keyword) fail("it is there twice");
    }
    require_text(place, keyword.c_str(), others[i].value);
  }
}

std::optional<SpanFault> span_fault(const EphemerisMetadata& metadata) {
  const std::pair<const char*, const std::optional<Epoch>*> times[] = {
      {"START_TIME", &metadata.start_time},
      {"USEABLE_START_TIME", &metadata.useable_start_time},
      {"USEABLE_STOP_TIME", &metadata.useable_stop_time},
      {"STOP_TIME", &metadata.stop_time}};
  const std::pair<const char*, const std::optional<Epoch>*>* before = nullptr;
  for (const auto& time : times) {
    if (!*time.second) continue;
    if (before && **time.second < **before->second)
      return SpanFault{time.first, before->first, **before->second};
    before = &time;
  }
  return std::nullopt;
}

std::string span_text(const EphemerisMetadata& metadata) {
  return "START_TIME, " + exact_text(*metadata.start_time, metadata.time_system) + ", and STOP_TIME, " +
         exact_text(*metadata.stop_time, metadata.time_system);
}

bool is_outside(const EphemerisMetadata& metadata, const Epoch& time) {
  constexpr Quantity<si::time> most_outside = 1e-3 * si::second;  // times are often written with 3 decimals
  return (time < *metadata.start_time && time < *metadata.start_time - most_outside) ||
         (*metadata.stop_time < time && *metadata.stop_time + most_outside < time);
}

void require_text(const std::string& place, const char* what, const std::string& value) {
  if (first_wrong(value, KvnText::value) != std::string::npos || trimmed(value) != value)
    throw BadInput(place + ": " + what + " '" + excerpt(value) +
                   "' is not one line of printable ASCII without blanks around it");
}

void require_comments(const std::string& place, const std::vector<std::string>& comments) {
  for (const std::string& comment : comments) {
    if (first_wrong(comment, KvnText::comment) != std::string::npos)
      throw BadInput(place + ": the comment '" + excerpt(comment) + "' is not one line of text");
  }
}

void require_header(const MessageHeader& header, const MessageKind& kind) {
  if (!kind.has(header.version))
    throw BadInput(std::string{kind.name} + ": the version is '" + excerpt(header.version) +
                   "'; the versions are " + kind.list());
  require_comments(kind.name, header.comments);
  require_text(kind.name, "CREATION_DATE", header.creation_date);
  require_text(kind.name, "ORIGINATOR", header.originator);
  require_text(kind.name, "CLASSIFICATION", header.classification);
  require_text(kind.name, "MESSAGE_ID", header.message_id);
  require_others(kind.name, kind, header.others);
  if (header.version != kind.newest() && !(header.classification.empty() && header.message_id.empty()))
    throw BadInput(std::string{kind.name} + ": CLASSIFICATION and MESSAGE_ID are of version " +
                   kind.newest() + ", the message of version " + header.version);
}

EphemerisMetadata checked_metadata(const std::string& place, const MessageKind& kind,
                                   EphemerisMetadata metadata, const std::vector<Epoch>& times) {
  require_text(place, "OBJECT_NAME", metadata.object_name);
  require_text(place, "OBJECT_ID", metadata.object_id);
  require_text(place, "CENTER_NAME", metadata.center_name);
  require_text(place, "the interpolation", metadata.interpolation);
  require_comments(place, metadata.comments);
  require_others(place, kind, metadata.others);
  if (!scale_named(metadata.time_system.name()))
    throw BadInput(place + ": TIME_SYSTEM is " + metadata.time_system.name() +
                   "; a message has UTC, TAI, TT, TDB or GPS");
  if (metadata.interpolation_degree && !is_degree(*metadata.interpolation_degree))
    throw BadInput(place + ": INTERPOLATION_DEGREE is " + text(*metadata.interpolation_degree) +
                   "; it is 0 to " + text(most_degree));
  if (times.empty()) throw BadInput(place + ": there are no samples");
  const auto shown = [&](const Epoch& time) { return text_of(place, time, metadata.time_system); };
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(times[i - 1] < times[i]))
      throw BadInput(place + ": sample " + text(i) + ", at " + shown(times[i]) +
                     ", is not later than the one before, at " + shown(times[i - 1]));
  }
  if (!metadata.start_time) metadata.start_time = times.front();
  if (!metadata.stop_time) metadata.stop_time = times.back();
  // A scale has a first epoch, and so has a text; the other times are between these.
  for (const Epoch& time : {*metadata.start_time, *metadata.stop_time, times.front(), times.back()})
    static_cast<void>(shown(time));
  if (const auto fault = span_fault(metadata))
    throw BadInput(place + ": " + fault->keyword + " is before " + fault->before + ", " +
                   shown(fault->limit));
  for (const Epoch& time : {times.front(), times.back()}) {
    if (is_outside(metadata, time))
      throw BadInput(place + ": the sample at " + shown(time) + " is outside " + span_text(metadata));
  }
  return metadata;
}

std::optional<std::string> system_fault(const EphemerisMetadata& metadata, const EphemerisMetadata& first) {
  if (metadata.time_system.kind() == first.time_system.kind()) return std::nullopt;
  return "the first segment has " + std::string{first.time_system.name()} + "; a message has one time system";
}

}  // namespace vectrix::detail

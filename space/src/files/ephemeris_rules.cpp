#include "ephemeris_rules.hpp"

#include <algorithm>
#include <utility>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "text_file.hpp"

namespace vectrix::detail {

bool MessageKind::has(const std::string& version) const {
  return std::find(versions.begin(), versions.end(), version) != versions.end();
}

std::string MessageKind::list() const {
  std::string list;
  for (const char* version : versions) list += (list.empty() ? "" : ", ") + std::string{version};
  return list;
}

const TimeScale* time_system(const std::string& capitals) {
  static constexpr const TimeScale* systems[] = {&scale::utc, &scale::tai, &scale::tt, &scale::tdb,
                                                 &scale::gps};
  for (const TimeScale* system : systems) {
    if (capitals == system->name()) return system;
  }
  return nullptr;
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
    if (before && **time.second < **before->second) return SpanFault{time.first, before->first};
    before = &time;
  }
  return std::nullopt;
}

bool is_outside(const EphemerisMetadata& metadata, const Epoch& time) {
  constexpr Quantity<si::time> most_outside = 1e-3 * si::second;  // times are often written with 3 decimals
  return (time < *metadata.start_time && time < *metadata.start_time - most_outside) ||
         (*metadata.stop_time < time && *metadata.stop_time + most_outside < time);
}

void require_text(const std::string& place, const char* what, const std::string& value) {
  const bool printable = std::all_of(value.begin(), value.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (!printable || trimmed(value) != value)
    throw BadInput(place + ": " + what + " '" + excerpt(value) +
                   "' is not one line of printable ASCII without blanks around it");
}

void require_comments(const std::string& place, const std::vector<std::string>& comments) {
  for (const std::string& comment : comments) {
    if (std::any_of(comment.begin(), comment.end(),
                    [](char c) { return (c >= 0 && c < ' ' && c != '\t') || c == 127; }))
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
  if (header.version != kind.newest() && !(header.classification.empty() && header.message_id.empty()))
    throw BadInput(std::string{kind.name} + ": CLASSIFICATION and MESSAGE_ID are of version " +
                   kind.newest() + ", the message of version " + header.version);
}

EphemerisMetadata checked_metadata(const std::string& place, EphemerisMetadata metadata,
                                   const std::vector<Epoch>& times) {
  require_text(place, "OBJECT_NAME", metadata.object_name);
  require_text(place, "OBJECT_ID", metadata.object_id);
  require_text(place, "CENTER_NAME", metadata.center_name);
  require_text(place, "the interpolation", metadata.interpolation);
  require_comments(place, metadata.comments);
  if (!time_system(metadata.time_system.name()))
    throw BadInput(place + ": TIME_SYSTEM is " + metadata.time_system.name() +
                   "; a message has UTC, TAI, TT, TDB or GPS");
  if (times.empty()) throw BadInput(place + ": there are no samples");
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(times[i - 1] < times[i]))
      throw BadInput(place + ": sample " + text(i) + " is not later than the one before");
  }
  if (!metadata.start_time) metadata.start_time = times.front();
  if (!metadata.stop_time) metadata.stop_time = times.back();
  if (const auto fault = span_fault(metadata))
    throw BadInput(place + ": " + fault->keyword + " is before " + fault->before);
  for (const Epoch& time : {times.front(), times.back()}) {
    if (is_outside(metadata, time))
      throw BadInput(place + ": the sample at " + exact_text(time, metadata.time_system) +
                     " is outside START_TIME and STOP_TIME");
  }
  return metadata;
}

void require_same_system(const std::string& place, const EphemerisMetadata& metadata,
                         const EphemerisMetadata& first) {
  if (metadata.time_system.kind() != first.time_system.kind())
    throw BadInput(place + ": the time system is " + metadata.time_system.name() + ", of the first segment " +
                   first.time_system.name() + "; a message has one");
}

}  // namespace vectrix::detail

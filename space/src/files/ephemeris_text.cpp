#include "ephemeris_text.hpp"

#include <algorithm>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "epoch_text.hpp"
#include "shifted_number.hpp"
#include "text_file.hpp"

namespace vectrix::detail {
namespace {

constexpr const Quantity<si::time> most_outside =
    1e-3 * si::second;  // times are often written with 3 decimals

std::string list_of(const MessageKind& kind) {
  std::string list;
  for (const char* version : kind.versions) list += (list.empty() ? "" : ", ") + std::string{version};
  return list;
}
bool is_version(const MessageKind& kind, const std::string& version) {
  return std::find(kind.versions.begin(), kind.versions.end(), version) != kind.versions.end();
}
std::string newest(const MessageKind& kind) {
  return *(kind.versions.end() - 1);
}

const TimeScale* time_system(const std::string& capitals) {
  static constexpr const TimeScale* systems[] = {&scale::utc, &scale::tai, &scale::tt, &scale::tdb,
                                                 &scale::gps};
  for (const TimeScale* system : systems) {
    if (capitals == system->name()) return system;
  }
  return nullptr;
}

struct SpanFault {
  const char *keyword, *before;
};
/// The first two times of the metadata that are not in order.
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
  return time < *metadata.start_time - most_outside || *metadata.stop_time + most_outside < time;
}

}  // namespace

MessageHeader read_header(KvnReader& reader, const MessageKind& kind) {
  MessageHeader header;
  bool more = reader.next();
  for (; more && reader.is_comment(); more = reader.next()) header.comments.push_back(reader.comment());
  const std::string first = "a message begins with " + std::string{kind.version_keyword};
  if (!more) throw BadInput(reader.place() + ": there is no message");
  if (reader.is_xml()) reader.fail("XML is not supported, only keyword = value");
  if (!reader.has_keyword()) reader.fail(first);
  const KvnLine version = reader.keyword();
  if (version.keyword != kind.version_keyword) refuse(reader.place(), version, first);
  if (!is_version(kind, version.value)) refuse(reader.place(), version, "the versions are " + list_of(kind));
  header.version = version.value;

  KvnEntries entries(reader.place(), "the message from line " + text(version.line) + " on");
  for (more = reader.next(); more && !reader.is("META_START"); more = reader.next()) {
    if (reader.is_comment()) {
      header.comments.push_back(reader.comment());
      continue;
    }
    KvnLine line = reader.keyword();
    const bool is_newer = line.keyword == "CLASSIFICATION" || line.keyword == "MESSAGE_ID";
    if (is_newer && header.version != newest(kind))
      entries.fail(line, "the keyword is of version " + newest(kind));
    if (!is_newer && line.keyword != "CREATION_DATE" && line.keyword != "ORIGINATOR")
      entries.fail(line, "the keyword is not of the header, which META_START ends");
    entries.add(std::move(line));
  }
  if (!more) throw BadInput(reader.place() + ": there is no META_START");
  const auto value = [&](const char* keyword) {
    const KvnLine* line = entries.find(keyword);
    return line ? line->value : std::string{};
  };
  header.creation_date = value("CREATION_DATE");
  header.originator = value("ORIGINATOR");
  header.classification = value("CLASSIFICATION");
  header.message_id = value("MESSAGE_ID");
  return header;
}

KvnEntries read_entries(KvnReader& reader, const std::string& version,
                        const std::vector<EphemerisKeyword>& keywords, std::vector<std::string>& comments) {
  KvnEntries entries(reader.place(), "the segment from line " + text(reader.line()) + " on");
  while (true) {
    if (!reader.next())
      throw BadInput(reader.place() + ", line " + text(reader.line()) + ": there is no META_STOP");
    if (reader.is("META_STOP")) return entries;
    if (reader.is_comment()) {
      comments.push_back(reader.comment());
      continue;
    }
    KvnLine line = reader.keyword();
    const auto known = std::find_if(keywords.begin(), keywords.end(), [&](const EphemerisKeyword& keyword) {
      return keyword.name == line.keyword;
    });
    if (known == keywords.end()) entries.fail(line, "the keyword is not of the metadata");
    if (version < known->since || version > known->until)
      entries.fail(line, "the keyword is of version " +
                             std::string{version < known->since ? known->since : known->until} +
                             ", the message of version " + version);
    entries.add(std::move(line));
  }
}

EphemerisMetadata metadata_of(const KvnEntries& entries, std::string_view interpolation_keyword) {
  EphemerisMetadata metadata{entries.line("OBJECT_NAME").value, entries.line("OBJECT_ID").value};
  if (const KvnLine* center = entries.find("CENTER_NAME")) metadata.center_name = center->value;
  const KvnLine& system = entries.filled("TIME_SYSTEM");
  const TimeScale* scale = time_system(upper_case(system.value));
  if (!scale) entries.fail(system, "the time systems that are read are UTC, TAI, TT, TDB and GPS");
  metadata.time_system = *scale;
  metadata.start_time = entries.epoch(entries.filled("START_TIME"), *scale);
  metadata.stop_time = entries.epoch(entries.filled("STOP_TIME"), *scale);
  if (const KvnLine* start = entries.find("USEABLE_START_TIME"))
    metadata.useable_start_time = entries.epoch(*start, *scale);
  if (const KvnLine* stop = entries.find("USEABLE_STOP_TIME"))
    metadata.useable_stop_time = entries.epoch(*stop, *scale);
  if (const auto fault = span_fault(metadata))
    entries.fail(entries.line(fault->keyword), "it is before " + std::string{fault->before});
  if (const KvnLine* method = entries.find(interpolation_keyword)) metadata.interpolation = method->value;
  if (const KvnLine* degree = entries.find("INTERPOLATION_DEGREE")) {
    constexpr std::int64_t most = 1000;
    const std::int64_t value = entries.whole(*degree);
    if (value > most) entries.fail(*degree, "no degree of an interpolation");
    metadata.interpolation_degree = static_cast<int>(value);
  }
  return metadata;
}

void require_same_system(const KvnEntries& entries, const EphemerisMetadata& metadata,
                         const EphemerisMetadata& first) {
  if (metadata.time_system.kind() != first.time_system.kind())
    entries.fail(
        entries.line("TIME_SYSTEM"),
        "the first segment has " + std::string{first.time_system.name()} + "; a message has one time system");
}

void require_same_system(const std::string& place, const EphemerisMetadata& metadata,
                         const EphemerisMetadata& first) {
  if (metadata.time_system.kind() != first.time_system.kind())
    throw BadInput(place + ": the time system is " + metadata.time_system.name() + ", of the first segment " +
                   first.time_system.name() + "; a message has one");
}

Epoch read_epoch(const KvnReader& reader, const KvnWord& word, const TimeScale& scale) {
  constexpr std::size_t longest = 40;
  if (word.text.size() > longest) reader.fail(word, "EPOCH", "too long for an epoch");
  try {
    return Epoch::from(scale, word.text);
  } catch (const BadInput& error) {
    reader.fail(word, "EPOCH", error.what());
  }
}

double read_number(const KvnReader& reader, const KvnWord& word, std::string_view name, int shift) {
  const auto value = parse_shifted(word.text, shift);
  if (!value) reader.fail(word, name, "not a finite number");
  return *value;
}

Epoch read_time(const KvnReader& reader, const KvnWord& word, const EphemerisMetadata& metadata,
                const Epoch* before) {
  const Epoch time = read_epoch(reader, word, metadata.time_system);
  if (before && !(*before < time)) reader.fail(word, "EPOCH", "not later than the line before");
  if (is_outside(metadata, time)) reader.fail(word, "EPOCH", "outside START_TIME and STOP_TIME");
  return time;
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
  if (!is_version(kind, header.version))
    throw BadInput(std::string{kind.name} + ": the version is '" + excerpt(header.version) +
                   "'; the versions are " + list_of(kind));
  require_comments(kind.name, header.comments);
  require_text(kind.name, "CREATION_DATE", header.creation_date);
  require_text(kind.name, "ORIGINATOR", header.originator);
  require_text(kind.name, "CLASSIFICATION", header.classification);
  require_text(kind.name, "MESSAGE_ID", header.message_id);
  if (header.version != newest(kind) && !(header.classification.empty() && header.message_id.empty()))
    throw BadInput(std::string{kind.name} + ": CLASSIFICATION and MESSAGE_ID are of version " + newest(kind) +
                   ", the message of version " + header.version);
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

void write_line(std::string& out, std::string_view keyword, const std::string& value) {
  out.append(keyword).append(" = ").append(value).append("\n");
}

void write_comments(std::string& out, const std::vector<std::string>& comments) {
  for (const std::string& comment : comments) out.append("COMMENT ").append(comment).append("\n");
}

void write_header(std::string& out, const MessageHeader& header, const MessageKind& kind) {
  write_line(out, kind.version_keyword, header.version);
  write_comments(out, header.comments);
  if (!header.classification.empty()) write_line(out, "CLASSIFICATION", header.classification);
  write_line(out, "CREATION_DATE", header.creation_date);
  write_line(out, "ORIGINATOR", header.originator);
  if (!header.message_id.empty()) write_line(out, "MESSAGE_ID", header.message_id);
}

void write_object(std::string& out, const EphemerisMetadata& metadata) {
  write_comments(out, metadata.comments);
  write_line(out, "OBJECT_NAME", metadata.object_name);
  write_line(out, "OBJECT_ID", metadata.object_id);
  if (!metadata.center_name.empty()) write_line(out, "CENTER_NAME", metadata.center_name);
}

void write_span(std::string& out, const EphemerisMetadata& metadata) {
  const auto write_time = [&](const char* keyword, const std::optional<Epoch>& time) {
    if (time) write_line(out, keyword, exact_text(*time, metadata.time_system));
  };
  write_line(out, "TIME_SYSTEM", metadata.time_system.name());
  write_time("START_TIME", metadata.start_time);
  write_time("USEABLE_START_TIME", metadata.useable_start_time);
  write_time("USEABLE_STOP_TIME", metadata.useable_stop_time);
  write_time("STOP_TIME", metadata.stop_time);
}

void write_interpolation(std::string& out, const EphemerisMetadata& metadata, std::string_view keyword) {
  if (!metadata.interpolation.empty()) write_line(out, keyword, metadata.interpolation);
  if (metadata.interpolation_degree)
    write_line(out, "INTERPOLATION_DEGREE", text(*metadata.interpolation_degree));
}

}  // namespace vectrix::detail

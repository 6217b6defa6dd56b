#include "convert.hpp"

#include <algorithm>
#include <cctype>
#include <ostream>
#include <vector>

#include "new_file.hpp"
#include "plain_attitude.hpp"

namespace vectrix::cli {
namespace {

std::string small(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ",") + word;
  return all;
}

std::string table(const PlainAttitude& attitude, const std::string& file) {
  const std::string reference = small(attitude.reference), scale = small(attitude.time_scale.name()),
                    axes = attitude.rate_axes == RateAxes::body ? "body" : "reference",
                    unit = attitude.rates_in_degrees ? "deg/s" : "rad/s";
  const std::string time = "time_" + scale, q = "q_" + reference + "_from_body_";
  const std::string w = "rate_in_" + (axes == "body" ? axes : reference) +
                        (attitude.rates_in_degrees ? "_deg_per_s_" : "_rad_per_s_");
  const std::vector<std::string> quaternion{q + "w", q + "x", q + "y", q + "z"}, rate{w + "x", w + "y", w + "z"};
  std::string text = "# Attitude of " + attitude.body + " relative to " + attitude.reference + ", from " + file +
                     ".\n# R(q) of Hamilton's product takes coordinates from the body to " + attitude.reference +
                     ". The scalar, w, is first.\n# Options to read it: --time " + time + " --scale " + scale +
                     " --quaternion " + joined(quaternion) + " --scalar first --maps reference --reference " +
                     attitude.reference;
  if (!attitude.rates.empty())
    text += " --rates " + joined(rate) + " --rate-unit " + unit + " --rate-axes " + axes;
  text += "\n" + time + "," + joined(quaternion) + (attitude.rates.empty() ? "" : "," + joined(rate)) + "\n";
  for (std::size_t i = 0; i < attitude.times.size(); ++i) {
    text += exact_text(attitude.times[i], attitude.time_scale);
    for (const double number : attitude.quaternions[i]) text += "," + exact_number(number);
    if (!attitude.rates.empty())
      for (const double number : attitude.rates[i]) text += "," + exact_number(number);
    text += "\n";
  }
  return text;
}

// What the message says besides its data: of the message that was read, unless it is given.
MessageText message_text(const ConvertOptions& options, const AttitudeRecord& record) {
  MessageText text = record.message.value_or(MessageText{});
  if (!record.message) {
    std::string missing;
    const auto need = [&](const std::string& given, const char* option) {
      if (given.empty()) missing += std::string(missing.empty() ? "" : ", ") + option;
    };
    need(options.object_name, "--object-name NAME");
    need(options.object_id, "--object-id ID");
    need(options.originator, "--originator NAME");
    need(options.body, "--body FRAME");
    if (!missing.empty())
      throw BadInput(record.file + ": a table does not say what a message needs; missing: " + missing);
    text.metadata.time_system = record.time_scale;
  }
  text.header.version = options.version;
  text.header.creation_date = options.creation_date;
  const auto set = [](std::string& value, const std::string& given) {
    if (!given.empty()) value = given;
  };
  set(text.header.originator, options.originator);
  set(text.metadata.object_name, options.object_name);
  set(text.metadata.object_id, options.object_id);
  return text;
}

// The times of the metadata, for data from the first to the last time.
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

std::string message(const PlainAttitude& attitude, MessageText text) {
  detail::AttitudeLines lines;
  lines.place = "the message to be written";
  lines.ref_frame_a = attitude.reference;
  lines.ref_frame_b = attitude.body;
  lines.times = attitude.times;
  lines.comments = text.comments;
  if (!attitude.rates.empty()) {
    lines.type = AttitudeType::quaternion_rate;
    lines.rate_frame = attitude.rate_axes == RateAxes::reference ? "REF_FRAME_A" : "REF_FRAME_B";
  }
  for (std::size_t i = 0; i < attitude.times.size(); ++i) {
    const auto& q = attitude.quaternions[i];
    lines.numbers.insert(lines.numbers.end(), {q[1], q[2], q[3], q[0]});
    if (!attitude.rates.empty())
      lines.numbers.insert(lines.numbers.end(), attitude.rates[i].begin(), attitude.rates[i].end());
  }
  const AttitudeEphemerisMessage all(text.header, {{detail::trusted, text.metadata, std::move(lines)}});
  std::string written = all.text();
  try {
    static_cast<void>(AttitudeEphemerisMessage::parse(written));
  } catch (const BadInput& error) {
    throw BadInput(std::string("what would be written cannot be read, ") + error.what());
  }
  return written;
}

}  // namespace

void convert(const ConvertOptions& options, std::ostream& out) {
  const std::string kind = options.out.extension().string();
  if (kind != ".aem" && kind != ".csv")
    throw BadInput(options.out.string() + ": the name ends neither in .aem nor in .csv, which says what to write");
  const AttitudeRecord record = read_attitude(options.attitude);
  PlainAttitude attitude = plain(record);
  if (!options.body.empty()) attitude.body = options.body;
  if (!options.frame.empty()) attitude = relative_to_frame(std::move(attitude), inertial_name(options.frame));
  std::string text;
  if (kind == ".csv") {
    text = table(attitude, record.file);
  } else {
    attitude = as_in_a_message(std::move(attitude));
    MessageText words = message_text(options, record);
    if (!record.message || options.attitude.from || options.attitude.until)
      set_times(words.metadata, attitude.times.front(), attitude.times.back(), record.file);
    text = message(attitude, std::move(words));
  }
  write_new(options.out, text, options.force);
  out << options.out.string() << ": " << attitude.times.size() << " samples of " << attitude.body << " relative to "
      << attitude.reference << '\n';
  for (const std::string& what : attitude.computed) out << "  not to the last digit: " << what << '\n';
}

}  // namespace vectrix::cli

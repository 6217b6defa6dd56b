#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "files/replaced.hpp"
#include "temporary_file.hpp"

namespace vectrix {

/// The text of the BadInput that reading throws.
template <class Message> std::string complaint_of(const std::string& text) {
  return complaint([&] { Message::parse(text); });
}

/// What makes a message wrong, and the complaint: its place and its reason.
struct Fault {
  std::string old, by, reason;
};

/// With each fault alone in the text, reading throws its complaint.
template <class Message>
void expect_faults(const std::string& text, const std::string& kind, std::initializer_list<Fault> faults) {
  for (const auto& [old, by, reason] : faults)
    EXPECT_EQ(complaint_of<Message>(replaced(text, old, by)), kind + ", " + reason) << by;
}

}  // namespace vectrix

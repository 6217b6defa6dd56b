#include "message_kind.hpp"

#include <gtest/gtest.h>

#include "attitude_record.hpp"
#include "flown_orbit.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::message_kind_test {
namespace {

std::string header() {
  return "<header><CREATION_DATE>2026-11-29T00:00:00</CREATION_DATE><ORIGINATOR>ME</ORIGINATOR></header>";
}
std::string between(const std::string& system) {
  return "<TIME_SYSTEM>" + system +
         "</TIME_SYSTEM><START_TIME>2026-11-29T00:00:00</START_TIME><STOP_TIME>2026-11-29T00:00:10</"
         "STOP_TIME>";
}
std::string aem() {
  std::string text = "<aem id=\"CCSDS_AEM_VERS\" version=\"2.0\">" + header() +
                     "<body><segment><metadata><OBJECT_NAME>SAT</OBJECT_NAME><OBJECT_ID>2026-001A</OBJECT_ID>"
                     "<REF_FRAME_A>EME2000</REF_FRAME_A><REF_FRAME_B>SC_BODY_1</REF_FRAME_B>" +
                     between("UTC") + "<ATTITUDE_TYPE>QUATERNION</ATTITUDE_TYPE></metadata><data>";
  for (const char* const second : {"00", "10"})
    text += std::string("<attitudeState><quaternionEphemeris><EPOCH>2026-11-29T00:00:") + second +
            "</EPOCH><quaternion><Q1>0</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC></quaternion></quaternionEphemeris>"
            "</attitudeState>";
  return text + "</data></segment></body></aem>";
}
std::string oem() {
  std::string text = "<oem id=\"CCSDS_OEM_VERS\" version=\"2.0\">" + header() +
                     "<body><segment><metadata><OBJECT_NAME>SAT</OBJECT_NAME><OBJECT_ID>2026-001A</OBJECT_ID>"
                     "<CENTER_NAME>EARTH</CENTER_NAME><REF_FRAME>ICRF</REF_FRAME>" +
                     between("UTC") + "</metadata><data>";
  for (const char* const second : {"00", "05", "10"})
    text +=
        std::string("<stateVector><EPOCH>2026-11-29T00:00:") + second +
        "</EPOCH><X>7000</X><Y>0</Y><Z>0</Z><X_DOT>0</X_DOT><Y_DOT>7.5</Y_DOT><Z_DOT>0</Z_DOT></stateVector>";
  return text + "</data></segment></body></oem>";
}

class CombinedMessage : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& messages) const {
    return folder.written("all.xml", "<?xml version=\"1.0\"?>\n<ndm>" + messages + "</ndm>\n");
  }
  template <class Function> std::string refusal(const std::string& messages, const Function& function) const {
    return complaint([&] { (void)function(file(messages)); }, folder.file("all.xml"));
  }
  TemporaryFolder folder;
};

TEST_F(CombinedMessage, IsReadForTheOneMessageOfTheKindThatIsAskedFor) {
  for (const std::string& messages : {aem() + oem(), oem() + aem()}) {
    const auto both = file(messages);
    EXPECT_TRUE(is_message(both));
    EXPECT_FALSE(is_orbit_message(both));  // what is converted is the attitude
    EXPECT_EQ(read_message(both, {}).body, "SC_BODY_1");
    EXPECT_EQ(read_orbit_message(both).segments()[0].ref_frame(), "ICRF");
    const auto t = Epoch::from_utc("2026-11-29T00:00:05");
    const auto orbit =
        orbit_of_message(both, from_until(t, t + 1.0 * si::second), {Interpolation{"LAGRANGE", 2}});
    EXPECT_DOUBLE_EQ(orbit(t).position.coordinates().x(), 7e6);
  }
  EXPECT_TRUE(is_orbit_message(file(oem())));
}

TEST_F(CombinedMessage, IsRefusedWithoutOrWithSeveral) {
  EXPECT_EQ(refusal(oem() + oem(), read_attitude_message),
            "FILE: is a combined message, of which one AEM is read; it has 2 OEM");
  EXPECT_EQ(refusal(oem() + aem() + oem(), read_orbit_message),
            "FILE: is a combined message, of which one OEM is read; it has AEM, 2 OEM");
  EXPECT_EQ(refusal(aem(), read_mean_elements_messages),
            "FILE: is a combined message without an OMM; it has AEM");
}

TEST_F(CombinedMessage, IsNoEmptyFile) {
  const auto empty = folder.written("empty", " \n");
  EXPECT_EQ(complaint([&] { require_content(empty); }, empty), "FILE: is empty");
}

}  // namespace
}  // namespace vectrix::cli::message_kind_test

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
    EXPECT_EQ(read_message(both, {}).body, "SC_BODY_1");
    EXPECT_EQ(read_orbit_message(both).segments()[0].ref_frame(), "ICRF");
    const auto t = Epoch::from_utc("2026-11-29T00:00:05");
    const auto orbit =
        orbit_of_message(both, from_until(t, t + 1.0 * si::second), {Interpolation{"LAGRANGE", 2}});
    EXPECT_DOUBLE_EQ(orbit(t).position.coordinates().x(), 7e6);
  }
}

TEST_F(CombinedMessage, IsConvertedInOneKindThatIsStated) {
  const auto found = [&](const std::string& messages, const char* stated, const char* out) {
    const auto [kind, others] = kind_to_convert(file(messages), stated, out);
    return kind + ", without " + others;
  };
  const auto refused = [&](const std::string& messages, const char* stated, const char* out) {
    return refusal(messages, [&](const auto& path) { return kind_to_convert(path, stated, out); });
  };
  for (const char* const out : {"out.xml", "out.csv", "out.czml"}) {
    EXPECT_EQ(refused(aem() + oem() + oem(), "", out),
              "FILE: is a combined message; it has AEM, 2 OEM; missing: --kind aem|oem");
    EXPECT_EQ(found(aem() + oem(), "oem", out), "oem, without AEM");
    EXPECT_EQ(found(aem() + oem(), "aem", out), "aem, without OEM");
    EXPECT_EQ(found(oem(), "", out), "oem, without ");
  }
  for (const char* const out : {"out.aem", "out.bc", "out.a"})
    EXPECT_EQ(found(aem() + oem(), "", out), "aem, without OEM");
  for (const char* const out : {"out.oem", "OUT.OEM"})
    EXPECT_EQ(found(oem() + aem(), "", out), "oem, without AEM");
  EXPECT_EQ(refused(aem() + oem(), "omm", "out.omm"),
            "FILE: is a combined message; it has AEM, OEM; --kind is omm");
  EXPECT_EQ(refused("", "", "out.xml"), "FILE: is a combined message; it has nothing, none of AEM, OEM, OMM");
}

// It is said what reads them.
TEST_F(CombinedMessage, IsNoMessageOfOneInstant) {
  for (const auto& [kind, hint] :
       {std::pair{"APM",
                  "; an APM is an attitude at one instant, which no command takes; in C++ "
                  "AttitudeParameterMessage reads it"},
        {"OPM",
         "; an OPM is an orbit at one instant, which no command takes; in C++ OrbitParameterMessage "
         "reads it"},
        {"TDM", ""}}) {
    const auto one = folder.written("one.txt", "CCSDS_" + std::string(kind) + "_VERS = 2.0\n");
    const std::string is = std::string("FILE: is a message of the kind ") + kind + ", not ";
    EXPECT_EQ(complaint([&] { (void)kind_to_convert(one, "", "out.csv"); }, one),
              is + "AEM or OEM or OMM" + hint);
    EXPECT_EQ(complaint([&] { (void)read_attitude_message(one); }, one), is + "AEM" + hint);
    EXPECT_EQ(complaint([&] { (void)read_orbit_message(one); }, one), is + "OEM" + hint);
    EXPECT_EQ(complaint([&] { (void)read_mean_elements_messages(one); }, one), is + "OMM" + hint);
  }
  const auto aem_alone = folder.written("a.aem", "CCSDS_AEM_VERS = 2.0\n");
  EXPECT_EQ(complaint([&] { (void)kind_to_convert(aem_alone, "aem", "out.csv"); }, aem_alone),
            "FILE: is one message; --kind is of a combined one");
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

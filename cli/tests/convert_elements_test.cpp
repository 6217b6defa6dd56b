#include "convert.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "space/tests/orbit/check_sum.hpp"
#include "space/tests/temporary_file.hpp"
#include "temporary_folder.hpp"
#include "words.hpp"

namespace vectrix::cli::convert_elements_test {
namespace {

const std::string of_ctim =
    summed("1 52950U 22074G   23109.57820907  .00068572  00000-0  17802-2 0  999") + "\n" +
    summed("2 52950  97.5000 120.0000 0010000 100.0000 260.0000 15.3000000000001") + "\n";
const std::string of_iss =
    "ISS\n" + summed("1 25544U 98067A   23109.57820907  .00068572  00000-0  17802-2 0  999") + "\n" +
    summed("2 25544  51.6000 120.0000 0010000 100.0000 260.0000 15.5000000000001") + "\n";

struct Converted {
  std::string text, said;
};
Converted converted(const std::string& text, const std::string& name, const GivenText& given) {
  TemporaryFolder folder;
  TemporaryFile file(text);
  ConvertOptions options;
  options.out = folder.file(name);
  options.text = given;
  options.text.creation_date = "2026-11-29T00:00:00";
  std::ostringstream said;
  convert(ElementFile{file.path()}, options, said);
  std::ifstream in(options.out);
  return {{std::istreambuf_iterator<char>(in), {}}, said.str()};
}

TEST(ConvertElements, MakesMessagesOfTwoLines) {
  const auto made = converted("CTIM\n" + of_ctim + of_iss, "out.omm", {.originator = "ME"});
  TemporaryFile file(made.text);
  const auto messages = OrbitMeanElementsMessage::read(file.path());
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].object_name(), "CTIM");
  EXPECT_EQ(messages[0].object_id(), "2022-074G");
  EXPECT_EQ(*messages[0].text("ORIGINATOR"), "ME");
  EXPECT_EQ(*messages[0].text("CREATION_DATE"), "2026-11-29T00:00:00");
  EXPECT_EQ(*messages[1].text("MEAN_MOTION"), "15.5");
  EXPECT_NE(made.said.find("2 sets of elements for SGP4"), std::string::npos);
  EXPECT_NE(made.said.find("half of the derivative"), std::string::npos);
  // The same again as XML, and back: only the elements count, not the form.
  const auto xml = converted(made.text, "out.xml", {}), back = converted(xml.text, "out.omm", {});
  EXPECT_EQ(back.text, made.text);
  EXPECT_EQ(xml.text.find("<?xml"), 0U);
  EXPECT_EQ(xml.said.find("derivative"), std::string::npos);
}

TEST(ConvertElements, WantsWhatTwoLinesDoNotSay) {
  const auto refused = [](const std::string& text, const std::string& name, const GivenText& given) {
    return complaint([&] { converted(text, name, given); });
  };
  EXPECT_NE(refused(of_ctim, "out.omm", {}).find("missing: --originator NAME, --object-name NAME"),
            std::string::npos);
  EXPECT_EQ(refused(of_ctim, "out.omm", {.object_name = "CTIM", .originator = "ME"}), "nothing was thrown");
  EXPECT_NE(refused(of_iss, "out.omm", {}).find("missing: --originator NAME"), std::string::npos);
  EXPECT_NE(refused("CTIM\n" + of_ctim + of_iss, "out.omm", {.object_name = "X", .originator = "ME"})
                .find("it has the elements of 2 satellites; --object-name is of one"),
            std::string::npos);
  EXPECT_NE(refused(of_iss, "out.csv", {.originator = "ME"}).find("written as .omm or .xml"),
            std::string::npos);
}

TEST(ConvertElements, AreToldFromOtherFiles) {
  const auto are = [](const std::string& text) {
    TemporaryFile file(text);
    return content_of({file.path()}, {}, "", "out.xml").kind == Content::Kind::elements;
  };
  EXPECT_TRUE(are(of_ctim));
  EXPECT_TRUE(are("# a comment\n\n" + of_iss));
  EXPECT_TRUE(are(converted(of_iss, "out.omm", {.originator = "ME"}).text));
  EXPECT_TRUE(are(converted(of_iss, "out.xml", {.originator = "ME"}).text));
  EXPECT_TRUE(are(converted("CTIM\n" + of_ctim + of_iss, "out.xml", {.originator = "ME"}).text))
      << "combined";
  EXPECT_FALSE(are("t,q0,q1,q2,q3\n1 ,2,3,4,5\n"));
  EXPECT_FALSE(are("CCSDS_OEM_VERS = 2.0\n"));
  EXPECT_FALSE(are(""));
}

}  // namespace
}  // namespace vectrix::cli::convert_elements_test

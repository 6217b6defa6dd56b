#include <gtest/gtest.h>

#include <string>

#include <vectrix/space.hpp>

#include "files/faults.hpp"
#include "files/xml_ephemeris_texts.hpp"
#include "files/xml_parameter_texts.hpp"

namespace vectrix::xml_messages_test {
namespace {

// A document type can read files and grow without end; there is none in a message.
TEST(XmlMessages, DocumentTypesAndEntitiesAreRefused) {
  const std::string refused = "a document type; it can name other files and entities, and is refused";
  expect_faults<AttitudeEphemerisMessage>(
      attitude_xml, "attitude ephemeris message",
      {{"<aem xmlns", "<!DOCTYPE aem SYSTEM \"file:///etc/passwd\">\n<aem xmlns",
        "line 2, column 11: " + refused},
       {"<aem xmlns",
        "<!DOCTYPE a [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;\"><!ENTITY c \"&b;&b;&b;\">]><aem xmlns",
        "line 2, column 11: " + refused},
       {"<aem xmlns", "<!DOCTYPE a [<!ENTITY x \"<aem xmlns",
        "line 2, column 1: a document type, which is refused"},
       {"ORBITER", "&x;", "line 13, column 22: '&x;' is no entity of XML"},
       {"ORBITER", "A &#10;B", "line 13, column 24: '&#10;' is no entity of XML"},
       {"ORBITER", "&#xD800;", "line 13, column 22: '&#xD800;' is no entity of XML"},
       {"ORBITER", "&#x110000;", "line 13, column 22: '&#x110000;' is no entity of XML"},
       {"ORBITER", "R&D", "line 13, column 23: '&D' is no entity of XML"}});
}

TEST(XmlMessages, EveryFaultHasALineAColumnAndAReason) {
  expect_faults<AttitudeEphemerisMessage>(
      attitude_xml, "attitude ephemeris message",
      {{"version=\"1.0\">", "version=\"4.0\">",
        "line 2, column 2 (CCSDS_AEM_VERS): '4.0': the versions are 1.0, 2.0"},
       {" version=\"1.0\">", ">", "line 2, column 2 (CCSDS_AEM_VERS): '': the versions are 1.0, 2.0"},
       {"id=\"CCSDS_AEM", "id=\"CCSDS_OEM",
        "line 2, column 2: <aem>: its id is 'CCSDS_OEM_VERS', not CCSDS_AEM_VERS"},
       {"UTF-8", "ISO-8859-1",
        "line 1, column 3: <xml>: the encoding is 'ISO-8859-1'; UTF-8 is read, and UTF-16 with its mark"},
       {"</header>", "", "line 62, column 3: it is not well-formed: Start-end tags mismatch"},
       {"</aem>\n", "</aem>\n<aem/>\n", "line 63, column 2: <aem>: a second element outside of the first"},
       {"</aem>\n", "</aem>\nmore\n", "line 63, column 4: text behind the document"},
       {"<body>", "<trunk/><body>", "line 8, column 4: <trunk>: expected header or body"},
       {"<body>", "<body>text", "line 8, column 9: text between elements"},
       {"<metadata>", "<metdata></metdata><metadata>",
        "line 9, column 6: <segment>: expected metadata in it"},
       {"<OBJECT_ID/>", "<OBJECT_ID/><OBJECT_NAME>X</OBJECT_NAME>",
        "line 14, column 34 (OBJECT_NAME): 'X': the keyword is there for the second time, after line 13"},
       {"<OBJECT_ID/>", "", "the segment from line 9 on: there is no OBJECT_ID"},
       {"<OBJECT_ID/>", "<OBJECT_ID><X/></OBJECT_ID>", "line 14, column 21: <X>: an element within a value"},
       {"<OBJECT_ID/>", "<objectId/>", "line 14, column 10: <objectId>: 'objectId' is no keyword"},
       {"ORBITER", "OR\nBITER", "line 13, column 10: <OBJECT_NAME>: its value is of several lines"},
       {"ORBITER", "\xC3\x84", "line 13, column 22: the byte 195 is no printable character of ASCII"},
       {">TAI", ">GMST",
        "line 18, column 22 (TIME_SYSTEM): 'GMST': the time systems that are read are UTC, TAI, TT, TDB and "
        "GPS"},
       {"<STOP_TIME>2021-04-15T13:31:23.0", "<STOP_TIME>2021-04-15T13:31:19",
        "line 20, column 20 (STOP_TIME): '2021-04-15T13:31:19': it is before START_TIME, "
        "2021-04-15T13:31:20.000"},
       {"<MISSION_PHASE>cruise</MISSION_PHASE>", "<STOP_TIM>cruise</STOP_TIM>",
        "line 23, column 19 (STOP_TIM): 'cruise': the keyword is not of the standard, but nearly STOP_TIME"},
       {">0.6<", ">x<", "line 29, column 27 (Q1): 'x': not a finite number"},
       {">0.6<", ">0.6 0<", "line 29, column 27: '0.6 0': more than one number"},
       {">0.6<", "><", "line 29, column 24: <Q1>: it is empty"},
       {"<Q1>0.6</Q1>", "", "line 27, column 10: <attitudeState>: there is no Q1"},
       {"<Q1>0.6</Q1>", "<Q1>0.6</Q1><Q1>0.6</Q1>",
        "line 29, column 36: <Q1>: 'Q1' is not of this line of data, or twice"},
       {"<Q1>0.6", "<Q1 units=\"deg\">0.6", "line 29, column 24: <Q1>: the unit is 'deg'; it has no unit"},
       {"units=\"deg\">20", "unit=\"rad\">20",
        "line 55, column 14: <rotation2>: the attribute 'unit'; a value may have units, parameter, angle or "
        "rate"},
       {"units=\"deg\">20", "units=\"deg\" units=\"rad\">20",
        "line 55, column 14: <rotation2>: the attribute 'units' is there twice"},
       {"units=\"deg\">20", "units=\"rad\">20",
        "line 55, column 14: <rotation2>: the unit is 'rad', not 'deg'"},
       {"\"X_ANGLE\"", "\"Y_ANGLE\"", "line 51, column 10: <attitudeState>: there is no X_ANGLE"},
       {">0.6<", ">0.7<",
        "line 29, column 60 (QC): '+8e-001': of a quaternion whose norm is 1.0630145812734648; it may differ "
        "from 1 "
        "by 0.01"},
       {"2021-105T13:31:21", "2021-105T13:31:19",
        "line 32, column 18 (EPOCH): '2021-105T13:31:19': not later than the line before, at "
        "2021-04-15T13:31:20.000"},
       {"<attitudeState>", "<attitude/><attitudeState>",
        "line 27, column 10: <attitude>: expected attitudeState"},
       {"<quaternion>", "<quaternion><a><b><c><d/></c></b></a>",
        "line 29, column 27: <b>: elements within so many others are not of a message"}});
  expect_faults<OrbitEphemerisMessage>(
      orbit_xml, "orbit ephemeris message",
      {{"units=\"km\"", "units=\"ft\"", "line 12, column 2: <X>: the unit is 'ft', not 'km'"},
       {"units=\"km/s\"", "units=\"m\xC3\x97s\xE2\x81\xBB\xC2\xB9\"",
        "line 13, column 2: <X_DOT>: the attribute 'units' is not one line of printable ASCII"},
       {"<Y_DDOT>8</Y_DDOT>", "", "line 14, column 2: <stateVector>: there is no Y_DDOT"},
       {"<CY_Y>", "<CY_Y units=\"km\">", "line 19, column 2: <CY_Y>: the unit is 'km', not 'km**2'"},
       {"<CX_X>1</CX_X>", "", "line 16, column 2: <covarianceMatrix>: there is no CX_X"},
       {"<CX_X>", "<CX_X>1</CX_X><CX_X>", "line 17, column 2: <CX_X>: it is there twice"},
       {"<CX_X>", "<CX_Z>1</CX_Z><CX_X>", "line 17, column 2: <CX_Z>: it is not of a covariance"},
       {"<CX_X>1<", "<CX_X>-1<", "line 17, column 7 (covariance): '-1': a variance that is negative"}});
  expect_faults<OrbitParameterMessage>(
      orbit_parameters_xml, "orbit parameter message",
      {{"units=\"m**2\"", "units=\"s\"", "line 8, column 72 (DRAG_AREA): '10 [s]': the unit is [m**2]"},
       {"parameter=\"EARTH_MODEL\"", "parameter=\"earth model\"",
        "line 13, column 25: <USER_DEFINED>: 'USER_DEFINED_earth model' is no keyword"},
       {"<stateVector>", "<stateVector><x><y/></x>", "line 6, column 21: <x>: 'x' is no keyword"}});
}

}  // namespace
}  // namespace vectrix::xml_messages_test

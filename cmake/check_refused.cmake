# Checks one program that must not compile:
#     cmake -D COMPILER=… -D OPTIONS=<folder of plain.options, strict.options> -D LAYER=… -D PROGRAM=… [-D PAGE=…] -P …
# The program says in its comments what is wrong and what the compiler must say (CMake regular expressions, each of
# which must match the message), and repairs itself under REPAIRED:
#     // mistake: a rotation turns a vector expressed in another frame
#     // expect: VectorIn = Gcrf
# As it is, it must be refused, for that reason and in at most LINES printed lines; which header included which, and the
# number of errors, do not count. With -DREPAIRED it must compile without a warning: so nothing but the mistake is
# refused. A page, docs/refusals.md, must show what the compiler says.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/refusals.cmake)
set(ENV{LC_ALL} C)
function(fail why)
  message(NOTICE "${why}")
  message(FATAL_ERROR "Not refused as it must be")
endfunction()
if(NOT DEFINED LINES)
  set(LINES 12)
endif()

file(READ ${PROGRAM} text)
if(NOT text MATCHES "// mistake: [^\n]" OR NOT text MATCHES "// expect: [^\n]" OR NOT text MATCHES "\n#if[^\n]*REPAIRED")
  fail("${PROGRAM} needs a line '// mistake: …', a line '// expect: …' and an #ifdef REPAIRED")
endif()

set(precompiled)
if(EXISTS ${OPTIONS}/${LAYER}.hpp.gch)
  set(precompiled -include ${OPTIONS}/${LAYER}.hpp)
endif()
execute_process(COMMAND ${COMPILER} @${OPTIONS}/plain.options ${precompiled} -fsyntax-only ${PROGRAM}
                RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(status EQUAL 0)
  fail("${PROGRAM} contains a mistake, but the compiler accepts it")
endif()
if(NOT said MATCHES "error: " OR said MATCHES "fatal error: ")
  fail("${PROGRAM} is refused for a reason that is not its mistake:\n${said}")
endif()
while(text MATCHES "// expect: ([^\n]+)(.*)")
  set(expected "${CMAKE_MATCH_1}")
  set(text "${CMAKE_MATCH_2}")
  if(NOT said MATCHES "${expected}")
    fail("${PROGRAM} is refused, but nothing in the message matches '${expected}':\n${said}")
  endif()
endwhile()
string(REGEX REPLACE "(^|\n)(In file included from [^\n]*(\n +from [^\n]*)*|[0-9]+ errors? generated\\.)" "" counted "${said}")
string(REGEX MATCHALL "\n" counted "${counted}")
list(LENGTH counted count)
if(count GREATER LINES)
  fail("${PROGRAM} is refused in ${count} lines; at most ${LINES} are allowed:\n${said}")
endif()
if(DEFINED PAGE)
  file(READ ${PAGE} page)
  refusal_message(message "${said}")
  cmake_path(GET PROGRAM FILENAME name)
  refusal_shown(shown "${page}" ${LAYER}/tests/refused/${name})
  if(NOT shown STREQUAL message)
    fail("${PAGE} does not show what the compiler says of ${name}; run ./dev docs. It says:\n${said}")
  endif()
endif()

execute_process(COMMAND ${COMPILER} @${OPTIONS}/strict.options ${precompiled} -fsyntax-only -DREPAIRED ${PROGRAM}
                RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT status EQUAL 0 OR NOT said STREQUAL "")
  fail("${PROGRAM}, repaired, does not compile cleanly:\n${said}")
endif()

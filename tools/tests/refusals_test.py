#!/usr/bin/env python3
"""The harness of refused programs accepts good ones, and rejects each way in which one can prove nothing."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOOLS))

from diagnostics import split  # noqa: E402
from refusals import CHARACTERS, LINES, LONGEST_LINE_GCC, why_not_refused  # noqa: E402
from refused_cases import BadProgram, Case, case_names, read_topic  # noqa: E402

SAMPLES = TOOLS / "tests" / "samples"
GOOD_CASE = """namespace good {
// mistake: a name for a number
// expect: char
#ifdef REPAIRED
int length = 1;
#else
int length = "one";
#endif
}  // namespace good
"""


class Harness(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.plain = Path(self.folder.name) / "plain.options"
        self.plain.write_text("-std=c++20\n")
        self.strict = Path(self.folder.name) / "strict.options"
        self.strict.write_text("-std=c++20\n-Wall\n-Wshadow\n-Werror\n")

    def check(self, file: Path, *options: str) -> tuple[int, str]:
        command = [sys.executable, str(TOOLS / "refusals.py"), "check", "--compiler", os.environ.get("CXX", "g++")]
        command += ["--options", str(self.plain), "--strict", str(self.strict), *options, str(file)]
        done = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(done.stderr, "")
        return done.returncode, done.stdout

    def written(self, text: str) -> Path:
        file = Path(self.folder.name) / "topic.cpp"
        file.write_text(text)
        return file

    def test_accepts_good_cases(self) -> None:
        status, said = self.check(SAMPLES / "good.cpp")
        self.assertEqual(said, "tools/tests/samples/good.cpp: 2 cases refused, and accepted once repaired\n")
        self.assertEqual(status, 0)

    def test_rejects_each_case_that_proves_nothing(self) -> None:
        status, said = self.check(SAMPLES / "rejected.cpp")
        self.assertEqual(status, 1)
        for reason in (
            "rejected.cpp:7: no_mistake contains a mistake, but the compiler accepts it",
            "rejected.cpp:18: other_reason is refused, but nothing in the message matches 'Gyroscope'",
            "only_its_name_says_so is refused, but nothing in the message matches 'says_so|rejected'",
            "bad_repair repaired, does not compile cleanly",
            f"lines; at most {LINES} are allowed",
        ):
            self.assertIn(reason, said)
        self.assertEqual(said.count("tools/tests/samples/rejected.cpp:") - said.count("    tools/"), 5)

    def test_rejects_a_missing_header(self) -> None:
        status, said = self.check(SAMPLES / "missing_header.cpp")
        self.assertEqual(status, 1)
        self.assertIn("missing_header is refused for a reason that is not its mistake", said)

    def test_rejects_an_error_of_no_case(self) -> None:
        status, said = self.check(SAMPLES / "stray.cpp")
        self.assertEqual(status, 1)
        self.assertIn("stray.cpp: the compiler says what belongs to no case\n    tools/tests/samples/stray.cpp:4:", said)
        self.assertIn("stray.cpp: repaired, it does not compile cleanly", said)
        self.assertNotIn("metres_for_a_number", said)

    def test_limits_the_length_when_asked(self) -> None:
        file = self.written("// A long name\n" + GOOD_CASE.replace('"one"', "Long" + "g" * 900).replace("char", "Long"))
        self.assertEqual(self.check(file)[0], 0)
        status, said = self.check(file, "--limit-length")
        self.assertEqual(status, 1)
        self.assertRegex(said, "good is refused in .* characters; at most [0-9]+ are allowed")

    def test_limits_lines_and_characters(self) -> None:
        case = Case("name", 1, 2, "", ["wait"], [])
        self.assertIsNone(why_not_refused(case, ["error: wait"] * LINES, 800))
        self.assertIn("lines", str(why_not_refused(case, ["error: wait"] * (LINES + 1), 800)))
        line = "error: wait".ljust(CHARACTERS // 4)
        self.assertIsNone(why_not_refused(case, [line] * 3, LONGEST_LINE_GCC))
        self.assertIn("2003 characters", str(why_not_refused(case, [line] * 4, LONGEST_LINE_GCC)))
        self.assertIsNone(why_not_refused(case, [line] * 4, None))
        self.assertIn("a line of 501", str(why_not_refused(case, [line + "s"], 500)))


class Programs(unittest.TestCase):
    """The form of a file."""

    def rejects(self, text: str, reason: str) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "topic.cpp"
            file.write_text(text)
            with self.assertRaisesRegex(BadProgram, reason):
                case_names([read_topic(file)])

    def test_needs_what_the_compiler_must_say(self) -> None:
        self.rejects("// Title\n" + GOOD_CASE.replace("// expect: char\n", ""), "needs one line '// mistake")
        self.rejects("// Title\n" + GOOD_CASE.replace("// expect: char", "// expect: "), "needs one line '// mistake")
        self.rejects("// Title\n" + GOOD_CASE.replace("// mistake: a name for a number\n", ""), "needs one line '// mistake")

    def test_reads_each_comment_from_one_line(self) -> None:
        self.rejects("// Title\n" + GOOD_CASE.replace("// expect: char\n", "// expect: char\n// int\n"), "in a second line")
        self.rejects("// Title\n" + GOOD_CASE.replace("// expect: char\n", "// expect: char\n// of expect: int\n"), "in a second line")

    def test_needs_a_repair(self) -> None:
        self.rejects("// Title\n" + GOOD_CASE.replace("#ifdef REPAIRED", "#ifndef REPAIRED"), "needs one '#ifdef REPAIRED'")

    def test_needs_a_title_and_cases(self) -> None:
        self.rejects(GOOD_CASE, "title of the topic")
        self.rejects("// Title\n", "has no cases")

    def test_knows_where_a_case_ends(self) -> None:
        self.rejects("// Title\n" + GOOD_CASE.replace("}  // namespace good", "}"), "has no end")
        self.rejects("// Title\n// mistake: of nobody\n" + GOOD_CASE, "outside of every case")

    def test_needs_different_names(self) -> None:
        self.rejects("// Title\n" + GOOD_CASE + GOOD_CASE, "there is another")


class Diagnostics(unittest.TestCase):
    def test_a_note_belongs_to_the_error_before_it(self) -> None:
        said = """a.cpp: In function 'void f()':
a.cpp:3:5: error: use of deleted function
    3 |   f();
In file included from a.cpp:1:
b.hpp: In instantiation of 'struct B':
a.cpp:9:1:   required from here
b.hpp:7:1: note: declared here
b.hpp: In instantiation of 'struct C':
a.cpp:12:1:   required from here
b.hpp:8:1: error: no type
2 errors generated.
"""
        first, second = split(said)
        self.assertEqual(len(first.lines), 6)
        self.assertEqual([place.line for place in first.places()], [3, 9])
        self.assertEqual(second.lines[0], "b.hpp: In instantiation of 'struct C':")
        self.assertEqual([(place.file, place.line) for place in second.places()], [("b.hpp", 8), ("a.cpp", 12)])


if __name__ == "__main__":
    unittest.main()

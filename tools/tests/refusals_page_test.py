#!/usr/bin/env python3
"""docs/reference/refusals.md: what it makes of the messages of the programs, and that it notices what is out of date."""

import contextlib
import io
import sys
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOOLS))

import refusals_page  # noqa: E402
from marked_text import LostMarks, replace_marked  # noqa: E402
from refused_cases import read_topic  # noqa: E402

GOOD = TOOLS / "tests" / "samples" / "good.cpp"
SAID = """good.cpp: In function 'void f()':
good.cpp:15:7: error: use of deleted function 'void vectrix::wait(Metres) [with Left = double; Right = int]'
   15 |   wait(Metres{});
good.cpp:6:6: note: declared here
    6 | void wait(Metres) = delete;  // wait(time)
      |      ^~~~
good.cpp:9:9: note:   this explains nothing""".splitlines()
OWN_WORDS = ["good.cpp:1:1: error: could not convert 'x' {aka 'y'} from 'A' to 'B'"]


class Page(unittest.TestCase):
    def test_keeps_what_explains(self) -> None:
        self.assertEqual(
            refusals_page.explanation(SAID),
            [
                "error: use of deleted function 'void wait(Metres)",
                "   [with Left = double",
                "         Right = int]'",
                "note: declared here: void wait(Metres) = delete;  // wait(time)",
            ],
        )
        self.assertEqual(refusals_page.explanation(OWN_WORDS), ["error: could not convert 'x' {aka 'y'} from 'A' to 'B'"])

    def test_finds_the_rule(self) -> None:
        self.assertEqual(refusals_page.rule_of(refusals_page.explanation(SAID)), "wait(time)")
        self.assertEqual(refusals_page.rule_of(refusals_page.explanation(OWN_WORDS)), "could not convert … from … to …")

    def test_says_a_mistake_on_a_line(self) -> None:
        topic = read_topic(GOOD)
        entry = refusals_page.Entry(topic, topic.cases[0], [], "")
        self.assertEqual(
            refusals_page.in_words(entry),
            "metres are handed to a door that wants seconds ([`metres_for_seconds`](../../tools/tests/samples/good.cpp)): "
            "`wait(Metres{})` → `wait(Seconds{})`",
        )

    def test_shortens_code(self) -> None:
        self.assertEqual(refusals_page.code(["  return a || b;"]), "`a || b`")
        self.assertEqual(refusals_page.code(["x" * (refusals_page.SHORT + 1)]), "…")
        self.assertEqual(refusals_page.code([]), "nothing")

    def test_loses_no_mistake(self) -> None:
        topic = read_topic(GOOD)
        said = {topic.relative: {"metres_for_seconds": SAID, "metres_in_a_template": OWN_WORDS}}
        self.assertEqual(len(topic.cases), 2)
        for many in 1, 2:  # a section for each rule, or a line in the table of its layer
            refusals_page.MANY, kept = many, refusals_page.MANY
            page = refusals_page.generated([topic], said)
            refusals_page.MANY = kept
            for case in topic.cases:
                self.assertEqual(page.count(f"[`{case.name}`]"), 1)
            self.assertEqual(page.count("`wait(time)`"), 1)
            self.assertEqual("declared here: void wait(Metres) = delete" in page, many == 1)

    def test_keeps_a_rule_with_bars_in_its_cell(self) -> None:
        topic = read_topic(GOOD)
        entry = refusals_page.Entry(topic, topic.cases[0], [], "a | b")
        self.assertTrue(refusals_page.table("frames", [("a | b", [entry])])[4].startswith("| `a \\| b` | metres"))

    def test_notices_what_is_out_of_date(self) -> None:
        topic = read_topic(GOOD)
        messages = {topic.relative: {"metres_for_seconds": SAID, "metres_in_a_template": OWN_WORDS}}
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
            page = Path(folder) / "page.md"
            page.write_text(refusals_page.BEGIN + "[`no_such_case`](../good.cpp)\n" + refusals_page.END)
            self.assertEqual(refusals_page.update(page, [topic], messages, write=False), 1)
            self.assertIn("-[`no_such_case`](../good.cpp)", said.getvalue())
            self.assertIn("metres_for_seconds", said.getvalue())
            self.assertIn("run ./dev docs", said.getvalue())
            refusals_page.update(page, [topic], messages, write=True)
            self.assertEqual(refusals_page.update(page, [topic], messages, write=False), 0)

    def test_needs_its_marks(self) -> None:
        with self.assertRaises(LostMarks):
            replace_marked("no marks", refusals_page.BEGIN, refusals_page.END, "", "page.md")


if __name__ == "__main__":
    unittest.main()

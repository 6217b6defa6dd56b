#!/usr/bin/env python3
"""The message in README.md: what counts of it, and that another one is noticed."""

import contextlib
import io
import os
import sys
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOOLS))

import readme  # noqa: E402
from diagnostics import Compiler  # noqa: E402


class Readme(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_leaves_out_how_a_header_was_included(self) -> None:
        (self.folder / "wait.hpp").write_text("void wait(int) = delete;  // wait(time)\n")
        example = self.folder / "example.cpp"
        example.write_text("#include <wait.hpp>\n#ifdef MISTAKE\nvoid use() { wait(1); }\n#endif\n")
        message = readme.refusal(Compiler(os.environ.get("CXX", "g++")), [self.folder], example)
        self.assertIn("example.cpp:3:", message)
        self.assertIn("wait(time)", message)
        self.assertNotIn("included from", message)

    def test_needs_a_mistake(self) -> None:
        example = self.folder / "example.cpp"
        example.write_text("int right = 1;\n")
        with self.assertRaisesRegex(SystemExit, "compiles with its mistake"):
            readme.refusal(Compiler(os.environ.get("CXX", "g++")), [self.folder], example)

    def test_notices_another_message(self) -> None:
        page = self.folder / "page.md"
        page.write_text(f"{readme.BEGIN}an old message\n{readme.END}\n")
        with contextlib.redirect_stdout(io.StringIO()) as said:
            self.assertEqual(readme.update(page, "a new message\n", write=False), 1)
        self.assertIn("run ./dev docs. It says:\na new message", said.getvalue())
        self.assertEqual(readme.update(page, "a new message\n", write=True), 0)
        self.assertEqual(readme.update(page, "a new message\n", write=False), 0)


if __name__ == "__main__":
    unittest.main()

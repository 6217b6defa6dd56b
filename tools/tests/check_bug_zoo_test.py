#!/usr/bin/env python3
"""The check of the bug zoo finds each lie of a sample."""

import subprocess
import sys
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOOLS))

from check_bug_zoo import violations_of  # noqa: E402


class BugZoo(unittest.TestCase):
    def test_finds_each_lie(self) -> None:
        sample = TOOLS / "tests" / "samples" / "bug_zoo.md"
        done = subprocess.run([sys.executable, str(TOOLS / "check_bug_zoo.py"), str(sample)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        for lie in (
            "'An entry without a test' names no test",
            "there is no refused.frames.no_such_program",
            "there is no dynamics.BugZoo.NoSuchTest",
            "the page does not tell of kinematics.BugZoo.",
            "2 entries",
        ):
            self.assertIn(lie, done.stdout)

    def test_accepts_the_truth(self) -> None:
        page = "# Zoo\n" + "\n### Entry\n`refused.frames.dcm_default`, `frames.BugZoo.Transposed`\n" * 12
        self.assertEqual(violations_of(page, {"refused.frames.dcm_default"}, {"frames.BugZoo.Transposed"}), [])


if __name__ == "__main__":
    unittest.main()

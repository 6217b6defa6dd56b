#!/usr/bin/env python3
"""The bug zoo says what is tested: check_bug_zoo.py [page], by default the bug_zoo.md in docs/

Every entry (### ...) names a test, every test it names exists, and every TEST(BugZoo, ...) is told on the page:
    `refused.<layer>.<name>`     a case of the refused programs of the layer
    `<layer>.BugZoo.<name>`      TEST(BugZoo, <name>) in a bug_zoo_test.cpp of the layer
"""

import re
import sys
from pathlib import Path

from refused_cases import ROOT, case_names, read_topic, refused_files, shown_path

ENTRIES = 12  # at least


def refused_tests() -> set[str]:
    """refused.<layer>.<name> of every case."""
    return {f"refused.{name}" for name in case_names([read_topic(file) for file in refused_files()])}


def found_tests() -> set[str]:
    """<layer>.BugZoo.<name> of every TEST(BugZoo, <name>)."""
    tests = set()
    for file in ROOT.glob("*/tests/**/bug_zoo_test.cpp"):
        layer = file.relative_to(ROOT).parts[0]
        tests |= {f"{layer}.BugZoo.{name}" for name in re.findall(r"^TEST\(BugZoo, (\w+)\)", file.read_text(), re.M)}
    return tests


def violations_of(page: str, refused: set[str], found: set[str]) -> list[str]:
    """Where the page and the tests disagree."""
    named = re.findall(r"`(refused\.\w+\.\w+|\w+\.BugZoo\.\w+)`", page)
    entries = page.split("\n### ")[1:]
    violations = []
    for entry in entries:
        if not re.search(r"`(refused\.\w+|\w+\.BugZoo)\.\w+`", entry):
            violations.append(f"'{entry.splitlines()[0]}' names no test")
    if len(entries) < ENTRIES:
        violations.append(f"{len(entries)} entries, fewer than {ENTRIES}")
    violations += [f"there is no {test}" for test in named if test not in refused | found]
    violations += [f"the page does not tell of {test}" for test in sorted(found - set(named))]
    return violations


def main() -> int:
    pages = [Path(sys.argv[1])] if len(sys.argv) > 1 else list((ROOT / "docs").glob("**/bug_zoo.md"))
    if len(pages) != 1:
        print(f"docs/ has {len(pages)} pages bug_zoo.md")
        return 1
    violations = violations_of(pages[0].read_text(), refused_tests(), found_tests())
    for violation in violations:
        print(f"{shown_path(pages[0])}: {violation}")
    print(f"{len(violations)} where the page and the tests disagree")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())

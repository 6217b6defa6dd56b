#!/usr/bin/env python3
"""What the pages show is read by a test: check_docs.py [page ...], by default README.md and docs/**/*.md

Every fenced block is of a kind in doc_blocks.py, a program has main() and is followed by what it prints, lines of a program
are in it in this order, every test that a page names as `<file> <suite>.<name>` is in that file, every picture of the pages'
folders is on one of them, and docs/reference/units.md names every unit.
"""

import re
import sys
from pathlib import Path

from doc_blocks import Block, all_pages, read_blocks
from refused_cases import ROOT, read_topic, shown_path


def is_compiled(file: str) -> bool:
    """Whether the tests compile it: an example, or a test of a layer."""
    if not re.fullmatch(r"[a-z0-9_/]+\.cpp", file):
        return False
    folder, *rest = file.split("/")
    of_layer = rest[:1] == ["tests"] and (ROOT / folder / "include").is_dir()
    return of_layer or (folder == "examples" and len(rest) == 1)


def trimmed(text: str) -> list[str]:
    """The lines, with single blanks and without empty ones."""
    lines = (" ".join(line.split()) for line in text.splitlines())
    return [line for line in lines if line]


def missing_line(quoted: list[str], source: list[str]) -> str | None:
    """The first quoted line that the source does not have after those before."""
    at = 0
    for line in quoted:
        if line not in source[at:]:
            return line
        at = source.index(line, at) + 1
    return None


def source_of(file: Path, case: str | None) -> str | None:
    """The text of a file, or of one of its cases."""
    if case is None:
        return file.read_text()
    found = [each for each in read_topic(file).cases if each.name == case]
    return "\n".join(found[0].code) if found else None


def wrong_quotation(block: Block) -> str | None:
    file = block.of[0]
    case = block.of[1] if len(block.of) > 1 else None
    if not is_compiled(file):
        return f"'{file}' is no program that the tests compile"
    if not (ROOT / file).exists():
        return f"there is no {file}"
    source = source_of(ROOT / file, case)
    if source is None:
        return f"{file} has no case {case}"
    line = missing_line(trimmed(block.text), trimmed(source))
    return f"{file} does not have, or not in this order, '{line}'" if line else None


def runs(block: Block) -> bool:
    return block.is_commands or block.is_program and re.search(r"^int main\(", block.text, re.M) is not None


def wrong_block(block: Block, before: Block | None) -> str | None:
    """What is wrong with a block that stands after another."""
    ran = before is not None and runs(before)
    if ran and block.kind != "text":
        return "a program comes before this, and not what it prints"
    if block.is_program:
        return None if runs(block) else "no main(): neither a program nor said to be lines of one"
    if block.is_commands:
        return None
    if block.kind == "cpp":
        return wrong_quotation(block)
    if block.kind == "text":
        return None if ran else "no program stands before this output"
    if block.kind == "csv":
        named = re.fullmatch(r"[a-z0-9_]+\.csv", " ".join(block.of))
        return None if named else "a csv block needs the name of its file"
    return f"no test reads a block of the kind '{block.kind}'"


def wrong_blocks(page: Path) -> list[str]:
    blocks = read_blocks(page)
    violations = []
    for before, block in zip([None, *blocks], blocks):
        why = wrong_block(block, before)
        if why:
            violations.append(f"{shown_path(page)}:{block.line}: {why}")
    if blocks and runs(blocks[-1]):
        violations.append(f"{shown_path(page)}: a program comes at the end, and not what it prints")
    return violations


def missing_tests(page: Path) -> list[str]:
    """The tests that a page names and that are not there."""
    violations = []
    for file, suite, name in re.findall(r"`([a-z]+/tests/[a-z0-9_/]+\.cpp) (\w+)\.(\w+)`", page.read_text()):
        source = (ROOT / file).read_text() if (ROOT / file).exists() else ""
        if not re.search(rf"[A-Z]\({suite}, {name}[,)]", source):
            violations.append(f"{shown_path(page)}: {file} has no {suite}.{name}")
    return violations


def unseen_pictures(pages: list[Path]) -> list[str]:
    """The pictures in docs/**/pictures that no page shows."""
    shown = {(page.parent / link).resolve() for page in pages for link in re.findall(r"\]\(([^)#]+)\)", page.read_text())}
    pictures = sorted((ROOT / "docs").glob("**/pictures/*"))
    return [f"no page shows {shown_path(picture)}" for picture in pictures if picture.resolve() not in shown]


def missing_units(page: str) -> list[str]:
    """The units and their constants that the headers define and the text does not name."""
    headers = ROOT / "frames" / "include" / "vectrix" / "frames"
    units = re.findall(r"struct (\w+) : (?:unit<|detail::UnitTag)", (headers / "unit.hpp").read_text())
    constants = re.findall(r"UnitConstant<\w+> (\w+);", (headers / "units.hpp").read_text())
    return [name for name in units + constants if not re.search(rf"\bsi::{name}\b", page)]


def main() -> int:
    given = [Path(page) for page in sys.argv[1:]]
    pages = given or all_pages()
    violations = [violation for page in pages for violation in wrong_blocks(page) + missing_tests(page)]
    if not given:
        violations += unseen_pictures(pages)
        units = ROOT / "docs" / "reference" / "units.md"
        violations += [f"{shown_path(units)} does not name si::{unit}" for unit in missing_units(units.read_text())]
    for violation in violations:
        print(violation)
    print(f"{len(violations)} violations on {len(pages)} pages")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())

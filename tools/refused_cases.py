"""The refused programs: files of one topic each, with a mistake and its repair in every namespace.

    // Rotations                                             the title of the topic
    #include <vectrix/frames.hpp>
    ...                                                      frames that the cases share
    namespace dcm_default {
    // mistake: a rotation without a value
    // expect: Dcm<Body, Gcrf                                a regular expression; each must match the message
    #ifdef REPAIRED
    ...
    #else
    ...
    #endif
    }  // namespace dcm_default
"""

import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


class BadProgram(Exception):
    """A program that is not of the form above."""


@dataclass
class Case:
    name: str
    first: int  # line of 'namespace name {'
    last: int  # line of '}  // namespace name'
    mistake: str
    expects: list[str]
    code: list[str]  # the lines after the comments

    def branches(self) -> tuple[list[str], list[str], list[str], list[str]]:
        """The lines before, of the refused branch, of the repaired branch, and after."""
        repaired = next(i for i, line in enumerate(self.code) if line == "#ifdef REPAIRED")
        refused = self.code.index("#else", repaired)
        end = self.code.index("#endif", refused)
        return (
            self.code[:repaired],
            self.code[refused + 1 : end],
            self.code[repaired + 1 : refused],
            self.code[end + 1 :],
        )


@dataclass
class Topic:
    path: Path
    title: str
    cases: list[Case]

    @property
    def layer(self) -> str:
        """The folder of the layer: the first one below the root."""
        return self.relative.split("/")[0]

    @property
    def relative(self) -> str:
        return shown_path(self.path)


def shown_path(path: Path) -> str:
    """The path as messages show it: from the root, if it is below the root."""
    resolved = path.resolve()
    return resolved.relative_to(ROOT).as_posix() if resolved.is_relative_to(ROOT) else str(resolved)


def comments_of(lines: list[str], word: str) -> list[str]:
    """What follows '// word: '."""
    begin = f"// {word}: "
    return [line.removeprefix(begin) for line in lines if line.startswith(begin) and line != begin]


def read_case(path: Path, name: str, first: int, lines: list[str]) -> Case:
    """The case whose lines these are, from 'namespace name {' to the closing brace."""
    where = f"{shown_path(path)}:{first}: {name}"
    body = lines[1:-1]
    mistakes = comments_of(body, "mistake")
    expects = comments_of(body, "expect")
    if len(mistakes) != 1 or not expects:
        raise BadProgram(f"{where} needs one line '// mistake: ...' and lines '// expect: ...'")
    for before, line in zip(body, body[1:]):
        wrapped = before.startswith(("// mistake: ", "// expect: ")) and line.startswith("// ")
        if (wrapped or "expect:" in line) and not line.startswith("// expect: "):
            raise BadProgram(f"{where}: a comment goes on in a second line: {line}")
    code = [line for line in body if not line.startswith(("// mistake: ", "// expect: "))]
    marks = [line for line in code if line.startswith(("#if", "#el", "#end"))]
    if marks != ["#ifdef REPAIRED", "#else", "#endif"]:
        raise BadProgram(f"{where} needs one '#ifdef REPAIRED', '#else' and '#endif', and no other condition")
    return Case(name, first, first + len(lines) - 1, mistakes[0], expects, code)


def read_topic(path: Path) -> Topic:
    """The topic of one file."""
    lines = path.read_text().splitlines()
    if not lines or not lines[0].startswith("// "):
        raise BadProgram(f"{shown_path(path)}:1: the first line must be a comment with the title of the topic")
    cases: list[Case] = []
    number = 0
    while number < len(lines):
        opened = re.fullmatch(r"namespace (\w+) \{", lines[number])
        if opened:
            name = opened[1]
            close = f"}}  // namespace {name}"
            if close not in lines[number:]:
                raise BadProgram(f"{shown_path(path)}:{number + 1}: {name} has no end '{close}'")
            end = lines.index(close, number)
            cases.append(read_case(path, name, number + 1, lines[number : end + 1]))
            number = end
        elif lines[number].startswith(("// mistake: ", "// expect: ", "#if")):
            raise BadProgram(f"{shown_path(path)}:{number + 1}: outside of every case: {lines[number]}")
        number += 1
    if not cases:
        raise BadProgram(f"{shown_path(path)} has no cases")
    return Topic(path, lines[0].removeprefix("// "), cases)


def case_names(topics: list[Topic]) -> set[str]:
    """The names <layer>.<case>; no two cases of a layer may share one."""
    names: set[str] = set()
    for topic in topics:
        for case in topic.cases:
            name = f"{topic.layer}.{case.name}"
            if name in names:
                raise BadProgram(f"{topic.relative}:{case.first}: there is another {name}")
            names.add(name)
    return names


def refused_files(root: Path = ROOT) -> list[Path]:
    """All files of refused programs of all layers."""
    return sorted(root.glob("*/tests/**/refused/*.cpp"))

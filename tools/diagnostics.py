"""What g++ and clang print, split into diagnostics.

A diagnostic is an error or a warning, with the lines before it that say in which function or instantiation it stands,
and with the notes and the lines of source after it.
"""

import os
import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

LOCATED = re.compile(r"(?P<file>[^\s:][^:]*):(?P<line>\d+):(\d+:)? (?P<kind>fatal error|error|warning|note): ")
UNLOCATED = re.compile(r"\S+: (fatal error|error|warning): ")
CONTEXT = re.compile(
    r"\S.*: (In [a-z' ]*(function|constructor|destructor|instantiation|substitution|lambda|member|static)\b.*|At global scope):?$"
    r"|[^\s:][^:]*:\d+:(\d+:)?   (recursively )?required (from|by)\b"
    r"|[^\s:][^:]*:\d+:(\d+:)?   \[ skipping"
    r"|[^\s:][^:]*: +(recursively )?required (from|by)\b"
)
INSTANTIATED = re.compile(r"(?P<file>[^\s:][^:]*):(?P<line>\d+):.*(required from here|requested here)$")
INCLUDED = re.compile(r"In file included from |                 from ")
COUNTED = re.compile(r"\d+ (warnings?|errors?)( and \d+ errors?)? generated\.$")


@dataclass
class Place:
    file: str
    line: int


@dataclass
class Diagnostic:
    lines: list[str] = field(default_factory=list)
    place: Place | None = None

    def places(self) -> list[Place]:
        """Where it stands, then where what it stands in was instantiated."""
        found = [self.place] if self.place else []
        for line in self.lines:
            match = INSTANTIATED.match(line)
            if match:
                found.append(Place(match["file"], int(match["line"])))
        return found


def split(said: str) -> list[Diagnostic]:
    """The diagnostics of a compiler's output, without the stacks of includes and the number of errors."""
    diagnostics: list[Diagnostic] = []
    before: list[str] = []  # context of the diagnostic or note to come
    for line in said.splitlines():
        located = LOCATED.match(line)
        if INCLUDED.match(line) or COUNTED.match(line):
            continue
        if CONTEXT.match(line):
            before.append(line)
        elif (located and located["kind"] != "note") or (not located and UNLOCATED.match(line)):
            place = Place(located["file"], int(located["line"])) if located else None
            diagnostics.append(Diagnostic([*before, line], place))
            before = []
        else:
            if not diagnostics:
                diagnostics.append(Diagnostic())
            diagnostics[-1].lines += [*before, line]
            before = []
    if before:
        diagnostics.append(Diagnostic(before))
    return diagnostics


@dataclass
class Compiler:
    command: str

    @property
    def is_clang(self) -> bool:
        version = subprocess.run([self.command, "--version"], capture_output=True, text=True, check=True)
        return "clang" in version.stdout

    def check_syntax(self, arguments: list[str]) -> tuple[int, str]:
        """Its status and all that it says; errors are not limited in number."""
        unlimited = "-ferror-limit=0" if self.is_clang else "-fmax-errors=0"
        command = [self.command, *arguments, "-fsyntax-only", "-fdiagnostics-color=never", unlimited]
        done = subprocess.run(
            command, env={**os.environ, "LC_ALL": "C"}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )
        return done.returncode, done.stdout


def syntax_arguments(options: Path, precompiled: Path | None) -> list[str]:
    """The options in a file, and a header that is included first, if it has been compiled."""
    compiled = precompiled is not None and precompiled.with_name(precompiled.name + ".gch").exists()
    return [f"@{options}", *(["-include", str(precompiled)] if compiled else [])]

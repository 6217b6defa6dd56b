"""The fenced blocks of the pages.

    ```cpp                    a whole program
    ```sh vectrix             commands of the program vectrix
    ```text                   right after a program or commands: what they print
    ```csv <file>             a file that the programs of the page find beside them
    ```cpp <file> [<case>]    lines out of a program that the tests compile, or out of one case of refused programs

What stands between <!-- generated ... --> and <!-- end --> is left out: who writes it, tests it.
"""

from dataclasses import dataclass
from pathlib import Path

from refused_cases import ROOT

FENCE = "```"


class BadPage(Exception):
    """A page whose marks do not match."""


@dataclass
class Block:
    kind: str  # the first word after the fence; "unclosed" where the page ends in a block
    of: list[str]  # the other words
    line: int  # on which its text begins
    text: str

    @property
    def is_program(self) -> bool:
        return self.kind == "cpp" and not self.of

    @property
    def is_commands(self) -> bool:
        return self.kind == "sh" and self.of == ["vectrix"]


def all_pages(root: Path = ROOT) -> list[Path]:
    return [root / "README.md", *sorted((root / "docs").glob("**/*.md"))]


def page_name(page: Path, root: Path = ROOT) -> str:
    """The name in those of tests: readme, howto, tutorial.first."""
    folder = root / "docs" if page.is_relative_to(root / "docs") else root
    return page.relative_to(folder).with_suffix("").as_posix().replace("/", ".").lower()


def read_blocks(page: Path) -> list[Block]:
    lines = page.read_text().splitlines()
    blocks: list[Block] = []
    number = 0
    while number < len(lines):
        if lines[number].startswith("<!-- generated "):
            if "<!-- end -->" not in lines[number:]:
                raise BadPage(f"{page}:{number + 1}: the mark <!-- generated ... --> has no <!-- end -->")
            number = lines.index("<!-- end -->", number)
        elif lines[number].startswith(FENCE):
            first = number + 1
            closing = (i for i in range(first, len(lines)) if lines[i].startswith(FENCE))
            end = next(closing, len(lines))
            kind, *of = lines[number].removeprefix(FENCE).split() or [""]
            text = "".join(line + "\n" for line in lines[first:end])
            blocks.append(Block(kind if end < len(lines) else "unclosed", of, first + 1, text))
            number = end
        number += 1
    return blocks

#!/usr/bin/env python3
"""Writes the programs of the pages, for cmake/tests/docs.cmake: doc_programs.py --folder build/docs --layers frames ...

In <folder>/<page> each page has its programs, 1.cpp and so on, what they print, 1.txt, and its files. <folder>/programs.cmake
names the pages, and calls doc_program(<page> <number> <layer> ALONE|PRECOMPILED) for each program, and doc_commands(<page>
<number>) for commands of the program vectrix, 1.sh and so on. The layer is the highest of
which the program includes a header. PRECOMPILED are those that include the whole of it, <vectrix/layer.hpp>, if there are
several: to precompile that adds nothing to what they include.
"""

import argparse
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from doc_blocks import all_pages, page_name, read_blocks

TOLERANCE = "# rel 1e-5 abs 1e-12"  # a number may differ by one in the sixth digit, the last that is printed


@dataclass
class Program:
    page: str
    number: str
    layer: str
    whole_layer: bool  # whether it includes <vectrix/layer.hpp>


def layer_of(program: str, layers: list[str]) -> str:
    """The highest layer of which the program includes a header."""
    included = [layer for layer in layers if f"#include <vectrix/{layer}" in program]
    return included[-1] if included else layers[0]


def page_files(page: Path) -> dict[str, str]:
    """The files of a page, by name."""
    files: dict[str, str] = {}
    number = 0
    for block in read_blocks(page):
        if block.is_program:
            number += 1
            files[f"{number}.cpp"] = f'#line {block.line} "{page}"\n{block.text}'
        elif block.is_commands:
            number += 1
            files[f"{number}.sh"] = block.text
        elif block.kind == "text":
            files[f"{number}.txt"] = f"{TOLERANCE}\n{block.text}"
        elif block.kind == "csv":
            files[" ".join(block.of)] = block.text
    return files


def write(folder: Path, files: dict[str, str]) -> None:
    """Writes the files that differ, and removes others: what is unchanged is not compiled again."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        if old.is_file() and old.name not in files:
            old.unlink()
    for name, text in files.items():
        file = folder / name
        if not file.exists() or file.read_text() != text:
            file.write_text(text)


def programs_of(page: str, files: dict[str, str], layers: list[str]) -> list[Program]:
    programs = []
    for file, text in files.items():
        if file.endswith(".cpp"):
            layer = layer_of(text, layers)
            programs.append(Program(page, Path(file).stem, layer, f"#include <vectrix/{layer}.hpp>" in text))
    return programs


def calls(programs: list[Program]) -> list[str]:
    """The call of doc_program for each program. To precompile headers for one program alone is no gain."""
    users = Counter(program.layer for program in programs if program.whole_layer)
    lines = []
    for program in programs:
        precompiled = program.whole_layer and users[program.layer] > 1
        mode = "PRECOMPILED" if precompiled else "ALONE"
        lines.append(f"doc_program({program.page} {program.number} {program.layer} {mode})")
    return lines


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--folder", type=Path, required=True)
    parser.add_argument("--layers", nargs="+", required=True, help="from the lowest")
    options = parser.parse_args()
    pages = all_pages()
    lines = ["set(doc_pages", *(f'    "{page}"' for page in pages), ")"]
    programs: list[Program] = []
    for page in pages:
        files = page_files(page)
        if files:
            write(options.folder / page_name(page), files)
        programs += programs_of(page_name(page), files, options.layers)
        lines += [f"doc_commands({page_name(page)} {Path(file).stem})" for file in files if file.endswith(".sh")]
    lines += calls(programs)
    write(options.folder, {"programs.cmake": "\n".join(lines) + "\n"})
    return 0


if __name__ == "__main__":
    sys.exit(main())

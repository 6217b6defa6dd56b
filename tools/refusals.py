#!/usr/bin/env python3
"""Checks that the compiler refuses the mistakes of the refused programs, and accepts their repairs.

    refusals.py check --compiler g++ --options plain.options --strict strict.options [...] rotations.cpp ...
    refusals.py messages --compiler g++ --options plain.options --save folder rotations.cpp ...
    refusals.py page --messages folder [--write] rotations.cpp ...      docs/reference/refusals.md, compared or written
    refusals.py show frames.dcm_default                                 what the compiler says of one case

refused_cases.py says what such a program looks like. One call of the compiler takes all cases of a file with their
mistakes, another takes them repaired.
"""

import argparse
import json
import re
import sys
from pathlib import Path

import refusals_page
from diagnostics import Compiler, Diagnostic, split, syntax_arguments
from marked_text import LostMarks
from refused_cases import ROOT, BadProgram, Case, Topic, case_names, read_topic, refused_files

LINES = 12  # that the compiler may print of one mistake
CHARACTERS = 2000  # in all these lines
LONGEST_LINE_GCC = 800
LONGEST_LINE_CLANG = 600

Messages = dict[str, list[str]]  # the lines said of each case


def compile_topic(topic: Topic, compiler: Compiler, arguments: list[str]) -> tuple[int, list[Diagnostic]]:
    """Status and diagnostics; paths in the source folder are written from there, wherever it stands."""
    status, said = compiler.check_syntax([*arguments, str(topic.path.resolve())])
    return status, split(said.replace(f"{ROOT}/", ""))


def case_of(diagnostic: Diagnostic, topic: Topic) -> Case | None:
    """The case in which a diagnostic stands, or from which it was instantiated."""
    for place in diagnostic.places():
        for case in topic.cases:
            if place.file == topic.relative and case.first <= place.line <= case.last:
                return case
    return None


def by_case(diagnostics: list[Diagnostic], topic: Topic) -> tuple[Messages, list[str]]:
    """The lines said of each case, as if its names were in no namespace, and those that belong to no case."""
    messages: Messages = {case.name: [] for case in topic.cases}
    stray: list[str] = []
    for diagnostic in diagnostics:
        case = case_of(diagnostic, topic)
        if case:
            messages[case.name] += [line.replace(f"{case.name}::", "") for line in diagnostic.lines]
        else:
            stray += diagnostic.lines
    return messages, stray


def without_places(said: list[str]) -> str:
    """The text without the names of files, which prove nothing."""
    return "\n".join(re.sub(r"^\S+\.[ch]pp:", "", line) for line in said)


def why_not_refused(case: Case, said: list[str], longest: int | None) -> str | None:
    """What is wrong with the message of a mistake; <longest> is the limit of a line, or None for no limits of length."""
    text = "\n".join(said)
    if "error: " not in text:
        return "contains a mistake, but the compiler accepts it"
    if "fatal error: " in text:
        return "is refused for a reason that is not its mistake"
    for expect in case.expects:
        if not re.search(expect, without_places(said)):
            return f"is refused, but nothing in the message matches '{expect}'"
    if len(said) > LINES:
        return f"is refused in {len(said)} lines; at most {LINES} are allowed"
    if longest is not None and len(text) > CHARACTERS:
        return f"is refused in {len(text)} characters; at most {CHARACTERS} are allowed"
    if longest is not None and max(map(len, said)) > longest:
        return f"is refused in a line of {max(map(len, said))} characters; at most {longest} are allowed"
    return None


def failure(topic: Topic, case: Case, why: str, said: list[str]) -> str:
    return "\n".join([f"{topic.relative}:{case.first}: {case.name} {why}", *(f"    {line}" for line in said)])


def check_mistakes(topic: Topic, messages: Messages, stray: list[str], longest: int | None) -> list[str]:
    """The failures of the cases with their mistakes."""
    failures = []
    for case in topic.cases:
        why = why_not_refused(case, messages[case.name], longest)
        if why:
            failures.append(failure(topic, case, why, messages[case.name]))
    if stray:
        failures.append("\n    ".join([f"{topic.relative}: the compiler says what belongs to no case", *stray]))
    return failures


def check_repairs(topic: Topic, compiler: Compiler, arguments: list[str]) -> list[str]:
    """The failures of the repaired cases: nothing may be said of them."""
    status, diagnostics = compile_topic(topic, compiler, [*arguments, "-DREPAIRED"])
    messages, stray = by_case(diagnostics, topic)
    failures = [
        failure(topic, case, "repaired, does not compile cleanly", messages[case.name])
        for case in topic.cases
        if messages[case.name]
    ]
    if stray or (status != 0 and not failures):
        failures.append("\n    ".join([f"{topic.relative}: repaired, it does not compile cleanly", *stray]))
    return failures


def check(options: argparse.Namespace) -> int:
    """Checks the files; says all that is wrong with them, or how many cases passed."""
    compiler = Compiler(options.compiler)
    longest = (LONGEST_LINE_CLANG if compiler.is_clang else LONGEST_LINE_GCC) if options.limit_length else None
    topics = [read_topic(file) for file in options.files]
    case_names(topics)
    failures: list[str] = []
    for topic in topics:
        _, diagnostics = compile_topic(topic, compiler, syntax_arguments(options.options, options.precompiled))
        messages, stray = by_case(diagnostics, topic)
        wrong = check_mistakes(topic, messages, stray, longest)
        wrong += check_repairs(topic, compiler, syntax_arguments(options.strict, options.precompiled))
        if not wrong:
            print(f"{topic.relative}: {len(topic.cases)} cases refused, and accepted once repaired")
        failures += wrong
        if options.save:
            save(options.save, topic, messages)
    for text in failures:
        print(text, end="\n\n")
    return 1 if failures else 0


def keep_messages(options: argparse.Namespace) -> int:
    """Keeps what the compiler says of the mistakes; all that it judges is whether they are refused."""
    compiler = Compiler(options.compiler)
    for topic in map(read_topic, options.files):
        _, diagnostics = compile_topic(topic, compiler, syntax_arguments(options.options, options.precompiled))
        messages, _ = by_case(diagnostics, topic)
        for case in topic.cases:
            if "error: " not in "\n".join(messages[case.name]):
                raise BadProgram(f"{topic.relative}:{case.first}: {case.name} is not refused")
        save(options.save, topic, messages)
    return 0


def save(folder: Path, topic: Topic, messages: Messages) -> None:
    """Keeps what the compiler said, for the page."""
    folder.mkdir(parents=True, exist_ok=True)
    saved_file(folder, topic).write_text(json.dumps(messages, indent=1) + "\n")


def saved_file(folder: Path, topic: Topic) -> Path:
    return folder / f"{topic.layer}.{topic.path.stem}.json"


def page(options: argparse.Namespace) -> int:
    """Writes docs/reference/refusals.md from the messages that `check` or `messages` saved, or sees that it is what that gives."""
    topics = [read_topic(file) for file in options.files]
    case_names(topics)
    messages = {topic.relative: json.loads(saved_file(options.messages, topic).read_text()) for topic in topics}
    return refusals_page.update(options.page, topics, messages, options.write)


def show(options: argparse.Namespace) -> int:
    """Prints what the compiler says of one case, named <case>, <layer>.<case> or refused.<layer>.<case>."""
    compiler = Compiler(options.compiler)
    for topic in map(read_topic, refused_files()):
        for case in topic.cases:
            if f".refused.{topic.layer}.{case.name}".endswith(f".{options.name}"):
                _, diagnostics = compile_topic(topic, compiler, syntax_arguments(options.options, None))
                print(f"{topic.relative}:{case.first}: {case.mistake}")
                print("\n".join(by_case(diagnostics, topic)[0][case.name]))
                return 0
    print(f"There is no case {options.name}", file=sys.stderr)
    return 1


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)

    checking = commands.add_parser("check", help="compile every case with its mistake, and repaired")
    checking.add_argument("--strict", type=Path, required=True, help="options with warnings as errors, for the repairs")
    checking.add_argument("--limit-length", action="store_true", help="limit the characters of a message as well")
    checking.add_argument("--save", type=Path, help="a folder for what the compiler said, for the page")
    checking.set_defaults(run=check)

    keeping = commands.add_parser("messages", help="only keep what the compiler says, for the page")
    keeping.add_argument("--save", type=Path, required=True, help="a folder")
    keeping.set_defaults(run=keep_messages)

    for compiling in checking, keeping:
        compiling.add_argument("--compiler", required=True)
        compiling.add_argument("--options", type=Path, required=True, help="a file of options, for the mistakes")
        compiling.add_argument("--precompiled", type=Path, help="a header to include first, with its .gch beside it")
        compiling.add_argument("files", type=Path, nargs="+")

    paging = commands.add_parser("page", help="compare docs/reference/refusals.md with what was said")
    paging.add_argument("--messages", type=Path, required=True, help="where check or messages saved")
    paging.add_argument("--page", type=Path, default=ROOT / "docs" / "reference" / "refusals.md")
    paging.add_argument("--write", action="store_true", help="write the page instead")
    paging.add_argument("files", type=Path, nargs="+", help="in the order of the page")
    paging.set_defaults(run=page)

    showing = commands.add_parser("show", help="print what the compiler says of one case")
    showing.add_argument("--compiler", default="g++")
    showing.add_argument("--options", type=Path, default=ROOT / "build" / "gcc" / "syntax" / "plain.options",
                         help="default: as written by cmake --preset gcc")  # fmt: skip
    showing.add_argument("name")
    showing.set_defaults(run=show)
    return parser.parse_args(arguments)


def main() -> int:
    options = parse(sys.argv[1:])
    try:
        return options.run(options)
    except (BadProgram, LostMarks) as bad:
        print(bad)
        return 1


if __name__ == "__main__":
    sys.exit(main())

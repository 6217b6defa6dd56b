#!/usr/bin/env python3
"""The checks of the pages find each lie of a sample, and the programs of a page are written as it shows them."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOLS = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(TOOLS))

import doc_programs  # noqa: E402
from check_docs import is_compiled, missing_units, wrong_blocks, wrong_quotation  # noqa: E402
from doc_blocks import BadPage, Block, page_name, read_blocks  # noqa: E402

SAMPLE = TOOLS / "tests" / "samples" / "docs.md"


class Lies(unittest.TestCase):
    def test_finds_each(self) -> None:
        done = subprocess.run([sys.executable, str(TOOLS / "check_docs.py"), str(SAMPLE)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        for lie in (
            "docs.md:8: no main",
            "docs.md:12: 'README.md' is no program",
            "docs.md:16: there is no examples/",
            "docs.md:20: examples/wrong_frame.cpp does not have",
            "docs.md:25: no program stands before",
            "docs.md:29: a csv block needs",
            "docs.md:33: no test reads a block of the kind 'sh'",
            "docs.md:49: a program comes before this",
            "docs.md:53: no test reads a block of the kind 'unclosed'",
            "dcm_test.cpp has no Dcm.NoSuchTest",
            "10 violations",
        ):
            self.assertIn(lie, done.stdout)

    def test_quotes_one_case(self) -> None:
        file = "frames/tests/refused/rotations.cpp"
        line = "return -R_body_from_gcrf;"
        self.assertIsNone(wrong_quotation(Block("cpp", [file, "dcm_negated"], 1, line)))
        self.assertIn("does not have", str(wrong_quotation(Block("cpp", [file, "dcm_default"], 1, line))))
        self.assertIn("has no case", str(wrong_quotation(Block("cpp", [file, "no_such_case"], 1, line))))

    def test_knows_what_is_compiled(self) -> None:
        self.assertTrue(is_compiled("frames/tests/graph/path_test.cpp"))
        for file in ("program.cpp", "examples/tests/compare.cpp", "tools/tests/samples/good.cpp", "docs/howto.md"):
            self.assertFalse(is_compiled(file))

    def test_misses_units(self) -> None:
        missing = missing_units("si::length and si::metre")
        for unit in ("torque", "degree_unit", "per", "newton_metre"):
            self.assertIn(unit, missing)
        for unit in ("length", "metre", "UnitTag"):
            self.assertNotIn(unit, missing)


class Programs(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_writes_what_the_page_shows(self) -> None:
        page = self.folder / "page.md"
        page.write_text("# Page\n```csv points.csv\nx\n```\n```cpp\nint main() {}\n```\n```text\nnothing\n```\n")
        files = doc_programs.page_files(page)
        self.assertEqual(files["points.csv"], "x\n")
        self.assertEqual(files["1.cpp"], f'#line 6 "{page}"\nint main() {{}}\n')
        self.assertEqual(files["1.txt"], f"{doc_programs.TOLERANCE}\nnothing\n")
        self.assertEqual(len(doc_programs.programs_of("page", files, ["frames", "kinematics"])), 1)

    def test_runs_commands(self) -> None:
        page = self.folder / "page.md"
        page.write_text("```sh vectrix\nvectrix --version\n```\n```text\n0.1\n```\n")
        files = doc_programs.page_files(page)
        self.assertEqual(files["1.sh"], "vectrix --version\n")
        self.assertEqual(files["1.txt"], f"{doc_programs.TOLERANCE}\n0.1\n")
        self.assertEqual(wrong_blocks(page), [])
        page.write_text("```sh vectrix\nvectrix --version\n```\nand no output\n")
        self.assertEqual(len(wrong_blocks(page)), 1)

    def test_finds_the_layer(self) -> None:
        layers = ["frames", "kinematics", "dynamics"]
        self.assertEqual(doc_programs.layer_of("#include <vectrix/frames.hpp>\n", layers), "frames")
        both = "#include <vectrix/dynamics/csv_table.hpp>\n#include <vectrix/kinematics.hpp>\n"
        self.assertEqual(doc_programs.layer_of(both, layers), "dynamics")

    def test_precompiles_what_several_include(self) -> None:
        texts = ["frames.hpp", "kinematics.hpp", "kinematics.hpp", "kinematics/screw.hpp"]
        files = {f"{i}.cpp": f"#include <vectrix/{text}>\n" for i, text in enumerate(texts)}
        programs = doc_programs.programs_of("page", files, ["frames", "kinematics"])
        self.assertEqual(
            doc_programs.calls(programs),
            [
                "doc_program(page 0 frames ALONE)",
                "doc_program(page 1 kinematics PRECOMPILED)",
                "doc_program(page 2 kinematics PRECOMPILED)",
                "doc_program(page 3 kinematics ALONE)",
            ],
        )

    def test_removes_what_the_page_no_longer_shows(self) -> None:
        doc_programs.write(self.folder, {"points.csv": "x\n", "1.cpp": "int main() {}\n"})
        doc_programs.write(self.folder, {"1.cpp": "int main() {}\n"})
        self.assertEqual([file.name for file in self.folder.iterdir()], ["1.cpp"])

    def test_passes_over_what_is_generated(self) -> None:
        page = self.folder / "page.md"
        page.write_text("<!-- generated by nobody -->\n```\nsaid\n```\n<!-- end -->\n")
        self.assertEqual(read_blocks(page), [])
        page.write_text("<!-- generated by nobody -->\n```\nsaid\n```\n")
        with self.assertRaises(BadPage):
            read_blocks(page)

    def test_names_pages_of_folders(self) -> None:
        root = Path("/root")
        self.assertEqual(page_name(root / "README.md", root), "readme")
        self.assertEqual(page_name(root / "docs" / "tutorial" / "first.md", root), "tutorial.first")


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""Each violation that tools/includes.py knows is found, and nothing else is."""
from __future__ import annotations

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import includes


def found_in(files: dict[str, str]) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            file = Path(folder) / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        includes.code.cache_clear()
        includes.included.cache_clear()
        return includes.violations(Path(folder).resolve())


FRAMES = "frames/include/vectrix/frames/a.hpp"
KINEMATICS = "kinematics/include/vectrix/kinematics/b.hpp"


class Direction(unittest.TestCase):
    def test_each_include_against_it(self) -> None:
        for file, header in (
            ("frames/tests/deep/a_test.cpp", "vectrix/kinematics/rate.hpp"),
            (FRAMES, "vectrix/space.hpp"),
            (KINEMATICS, "vectrix/dynamics/ode.hpp"),
            ("space/src/c.cpp", "vectrix/dynamics.hpp"),
            ("testing/d.hpp", "vectrix/dynamics.hpp"),
            ("space/include/vectrix/space/e.hpp", "erfa.h"),
            ("dynamics/src/f.cpp", "erfam.h"),
            ("dynamics/include/vectrix/dynamics/multibody/l.hpp", "vectrix/frames/vector.hpp"),
            ("dynamics/src/multibody/m.cpp", "vectrix/dynamics/mass/inertia.hpp"),
            ("space/src/g.cpp", "cvode/cvode.h"),
            ("dynamics/tests/h_test.cpp", "sundials/sundials_types.h"),
            ("accuracy/i.cpp", "arkode/arkode.h"),
            ("validation/j.cpp", "Simbody.h"),
            ("simbody/include/vectrix/simbody/n.hpp", "simbody/internal/common.h"),
            ("dynamics/src/o.cpp", "vectrix/simbody.hpp"),
            ("simbody/src/p.cpp", "cvode/cvode.h"),
            ("validation/earth.cpp", "erfa.h"),
            ("bench/k.cpp", "SimTKcommon.h"),
        ):
            self.assertEqual(found_in({file: f"  # include <{header}>\n"}),
                             [f"{file}: includes {header}, against the direction of dependence"])

    def test_what_is_allowed(self) -> None:
        self.assertEqual(found_in({
            KINEMATICS: "#include <vectrix/frames/a.hpp>\n",
            "space/src/c.cpp": "#include <erfa.h>\n#include <vectrix/kinematics.hpp>\n",
            "space/tests/e_test.cpp": "#include <erfa.h>\n",
            "dynamics/src/f.cpp": "#include <cvode/cvode.h>\n",
            "dynamics/src/multibody/g.cpp": "#include <vectrix/frames/scalar/batch.hpp>\n#include <vectrix/frames/errors.hpp>\n"
                                            "#include <vectrix/dynamics/multibody/tree.hpp>\n",
            "simbody/src/simbody_engine.cpp": "#include <Simbody.h>\n",
            "validation/erfa.cpp": "#include <erfa.h>\n",
            "validation/tests/simbody_conventions_test.cpp": "#include <Simbody.h>\n",
            "bench/peer_simbody.cpp": "#include <SimTKcommon.h>\n",
            "frames/tests/a_test.cpp": "// #include <vectrix/dynamics.hpp>\n",
        }), [])


class Engines(unittest.TestCase):
    def test_each_name(self) -> None:
        for name in ("CVodeCreate", "CV_ADAMS", "ARKodeFree", "ARK_NORMAL", "ERKStepCreate", "SUNMatrix",
                     "sunrealtype", "N_VNew", "realtype", "eraEpb", "SimTK"):
            self.assertEqual(found_in({FRAMES: f"struct {name};\n"}), [f"{FRAMES}: names '{name}' in a public header"])

    def test_names_of_ours_and_comments(self) -> None:
        self.assertEqual(found_in({FRAMES: "enum class Method { cvode_adams };  // CVodeCreate\n"}), [])


class Declarations(unittest.TestCase):
    def test_a_missing_header(self) -> None:
        self.assertEqual(found_in({FRAMES: "std::vector<int> list;\n"}), [f"{FRAMES}: std::vector needs one of: vector"])
        self.assertEqual(found_in({FRAMES: "#include <Eigen/Core>\nEigen::Quaterniond q;\n"}),
                         [f"{FRAMES}: Eigen::Quaterniond needs one of: Eigen/Geometry"])
        self.assertEqual(found_in({FRAMES: "#include <Eigen/Core>\nusing std::sqrt;\n"}),
                         [f"{FRAMES}: std::sqrt needs one of: cmath"])

    def test_a_header_of_ours_brings_it_and_a_foreign_one_does_not(self) -> None:
        vector = "#include <vector>\nstd::vector<int> list;\n"
        user = "#include <vectrix/frames/a.hpp>\nstd::vector<int> more;\n"
        self.assertEqual(found_in({FRAMES: vector, KINEMATICS: user}), [])
        self.assertEqual(found_in({FRAMES: "#include <map>\n", KINEMATICS: user}),
                         [f"{KINEMATICS}: std::vector needs one of: vector"])

    def test_headers_that_include_each_other(self) -> None:
        back = "#include <vectrix/kinematics/b.hpp>\n"
        self.assertEqual(len(found_in({FRAMES: back, KINEMATICS: "#include <vectrix/frames/a.hpp>\n"})), 1)

    def test_boost_is_included_where_it_is_named(self) -> None:
        self.assertEqual(found_in({FRAMES: "#include <boost/units/quantity.hpp>\n",
                                   KINEMATICS: "#include <vectrix/frames/a.hpp>\nboost::units::scale s;\n"}),
                         [f"{KINEMATICS}: boost:: needs an include of Boost in this header"])

    def test_a_name_that_no_table_has(self) -> None:
        self.assertEqual(found_in({FRAMES: "std::flat_map m;\n"}),
                         [f"{FRAMES}: std::flat_map is not in the table of tools/includes.py"])

    def test_comments_and_texts_do_not_count(self) -> None:
        self.assertEqual(found_in({FRAMES: '/// As std::vector.\nconst char* text = "std::vector \\" //";\n'}), [])


if __name__ == "__main__":
    unittest.main()

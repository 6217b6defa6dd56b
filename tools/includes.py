#!/usr/bin/env python3
"""Reads the #include lines of the sources: python3 tools/includes.py <source folder>. Three rules:

1. The direction of dependence:  frames <- kinematics <- space <- dynamics <- simbody <- examples, pictures, validation, accuracy.
   ERFA is known in space/src, space/tests, validation/erfa.cpp and bench/ alone, SUNDIALS in dynamics/src and
   bench/integrators alone, Simbody in simbody/src/simbody_*, validation/**/simbody_* and bench/peer_simbody.cpp
   alone. The multibody engine works on plain numbers: it includes nothing of ours but the scalars.
2. Public headers do not use a name of these engines either (an enumerator such as cvode_adams is ours).
3. A public header that says std::x or Eigen::x includes the header that declares it, itself or through headers of ours.
   Boost is not to be reached through others: a header that says boost:: includes it itself.

With rule 3, the test that compiles each header alone may precompile the foreign headers: it finds what is missing of
ours, the rule what is missing of theirs.
"""
from __future__ import annotations

import re
import sys
from functools import cache
from pathlib import Path
from typing import Iterator

LAYERS = ("frames", "kinematics", "space", "dynamics", "simbody")
ABOVE = ("cli", "examples", "pictures", "validation", "accuracy")

ERFA = "erfa"
SOLVERS = "sundials/|cvode/|arkode/|kinsol/|nvector/|sunmatrix/|sunlinsol/|sunnonlinsol/"
SIMBODY = "Simbody|SimTK|simbody/|simmath/|SimTKcommon/"
KNOWS_ITS_PEER = re.compile(r"(simbody/src/simbody_[^/]*|validation/(tests/)?simbody_[^/]*|validation/erfa\.cpp"
                            r"|bench/peer_simbody\.cpp)$")

# What no file below these folders includes.
FORBIDDEN = (
    ("vectrix/kinematics|vectrix/space|vectrix/dynamics|vectrix/simbody", ("frames",)),
    ("vectrix/space|vectrix/dynamics|vectrix/simbody", ("kinematics",)),
    ("vectrix/dynamics|vectrix/simbody", ("space", "testing")),
    ("vectrix/simbody", ("dynamics",)),
    (r"vectrix/(?!dynamics/multibody/|frames/(scalar/|errors\.hpp|export\.hpp))",
     ("dynamics/include/vectrix/dynamics/multibody", "dynamics/src/multibody")),
    (ERFA, ("frames", "kinematics", "space/include", "dynamics", "simbody", *ABOVE)),
    (SOLVERS, ("frames", "kinematics", "space", "dynamics/include", "dynamics/tests", "simbody", *ABOVE)),
    (SIMBODY, (*LAYERS, *ABOVE, "bench")),
)

ENGINE_NAME = re.compile(
    r"\b(?:CVode|CV_|ARK[oS]|ARK_|ERKStep|KIN[A-Z_]|SUN[A-Z]|sun[a-z]+type|sundials|N_V|realtype|era[A-Z]|SimTK)[A-Za-z_]*")

# The headers of the standard library, and the names that we use of each.
STANDARD = {
    "algorithm": "max min clamp sort stable_sort find find_if all_of any_of none_of lower_bound upper_bound unique copy "
                 "fill equal reverse count count_if max_element min_element minmax transform",
    "array": "array",
    "atomic": "atomic memory_order_relaxed memory_order_acquire memory_order_release",
    "cctype": "tolower toupper isspace isdigit isalpha",
    "charconv": "to_chars from_chars",
    "chrono": "chrono",
    "cmath": "abs sqrt sin cos tan asin acos atan atan2 exp log log10 pow hypot isfinite isnan isinf signbit copysign "
             "nextafter expm1 sinh cosh tanh floor ceil round fmod remainder ldexp frexp cbrt fma trunc lround",
    "compare": "strong_ordering weak_ordering partial_ordering",
    "complex": "complex",
    "concepts": "same_as integral floating_point invocable convertible_to derived_from constructible_from "
                "default_initializable copyable movable regular",
    "cstddef": "size_t ptrdiff_t byte nullptr_t",
    "cstring": "memcpy memcmp memset strlen",
    "cstdint": "uint8_t uint16_t uint32_t uint64_t int8_t int16_t int32_t int64_t uintptr_t",
    "deque": "deque",
    "exception": "exception exception_ptr nested_exception throw_with_nested rethrow_if_nested current_exception "
                 "rethrow_exception",
    "experimental/simd": "experimental",
    "filesystem": "filesystem",
    "functional": "function hash plus minus less greater reference_wrapper ref cref invoke",
    "initializer_list": "initializer_list",
    "iterator": "next prev distance back_inserter advance begin end ssize input_iterator_tag input_iterator",
    "limits": "numeric_limits",
    "map": "map multimap",
    "memory": "unique_ptr shared_ptr weak_ptr make_unique make_shared allocator enable_shared_from_this addressof assume_aligned",
    "mutex": "mutex lock_guard unique_lock scoped_lock try_to_lock once_flag call_once",
    "numbers": "numbers",
    "numeric": "iota accumulate inner_product midpoint",
    "optional": "optional nullopt make_optional",
    "ostream": "ostream",
    "random": "mt19937_64 uniform_real_distribution normal_distribution",
    "ranges": "ranges views",
    "set": "set",
    "shared_mutex": "shared_mutex shared_lock",
    "span": "span dynamic_extent",
    "sstream": "ostringstream istringstream stringstream",
    "stdexcept": "runtime_error invalid_argument logic_error out_of_range domain_error overflow_error",
    "string": "string to_string stod stoi",
    "string_view": "string_view",
    "thread": "thread this_thread",
    "tuple": "tuple tuple_element tuple_element_t tuple_size tuple_size_v make_tuple tie apply tuple_cat get",
    "type_traits": "is_same_v is_same type_identity type_identity_t enable_if_t enable_if remove_cvref_t remove_cv_t "
                   "remove_reference_t conditional conditional_t invoke_result invoke_result_t is_integral_v is_base_of_v "
                   "is_void_v is_empty_v is_final_v is_arithmetic_v is_invocable_v is_floating_point_v is_convertible_v "
                   "is_constructible_v is_default_constructible_v is_const_v is_reference_v is_lvalue_reference_v "
                   "is_trivially_copyable_v is_nothrow_move_constructible_v integral_constant bool_constant true_type "
                   "false_type decay_t common_type_t void_t add_const_t underlying_type_t is_enum_v is_class_v",
    "typeindex": "type_index",
    "typeinfo": "type_info",
    "unordered_map": "unordered_map",
    "unordered_set": "unordered_set",
    "utility": "move forward declval pair make_pair exchange swap index_sequence make_index_sequence integer_sequence "
               "make_integer_sequence index_sequence_for in_place as_const",
    "variant": "variant visit monostate holds_alternative",
    "vector": "vector",
}
# Headers that the standard promises to bring what is asked of another.
BRINGS = {
    "utility": {"tuple", "vector", "map", "optional", "string", "memory", "functional", "algorithm", "array", "deque"},
    "cstddef": {"array", "vector", "string", "string_view", "span", "tuple", "utility", "memory", "deque", "type_traits"},
    "ostream": {"iosfwd", "iostream", "sstream", "fstream"},
    "string": {"sstream", "iostream", "stdexcept", "ostream"},
    "tuple": {"array", "utility"},
    "functional": {"string", "string_view", "memory", "optional", "typeindex", "variant", "thread"},
    "initializer_list": {"vector", "string", "algorithm", "array", "utility", "map"},
    "typeinfo": {"typeindex"},
    "compare": {"utility", "string", "vector", "optional", "memory", "tuple"},
    "iterator": {"vector", "string", "array", "map", "deque", "span"},
}
EIGEN = {
    "Core": "PropagateNaN Matrix MatrixBase DenseBase Index NumTraits GenericNumTraits Vector3d Vector4d Vector2d Matrix3d Matrix4d "
            "Matrix2d VectorXd VectorXcd MatrixXd seqN fix Map Array Array2d Array3d ArrayBase Success Dynamic EigenBase Ref Block "
            "ComputeFullU ComputeFullV ComputeEigenvectors EigenvaluesOnly internal RowMajor ColMajor Infinity Lower",
    "Geometry": "Quaternion Quaterniond Quaternionf QuaternionBase AngleAxis AngleAxisd",
    "Eigenvalues": "SelfAdjointEigenSolver EigenSolver",
    "Cholesky": "LLT LDLT",
    "LU": "PartialPivLU FullPivLU",
    "QR": "HouseholderQR ColPivHouseholderQR",
    "SVD": "JacobiSVD BDCSVD",
    "Jacobi": "JacobiRotation",
}
EIGEN_BRINGS = {"Core": {"Geometry", "Eigenvalues", "Cholesky", "LU", "QR", "SVD", "Jacobi", "Dense"}}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.MULTILINE)
# An #include line, which stays; a text, a character, or a comment.
TEXT = re.compile(r"""([ \t]*\#[ \t]*include[ \t]*"[^"\n]*") | "(?:[^"\\\n]|\\.)*" | '(?:[^'\\\n]|\\.)' | //[^\n]*""",
                  re.VERBOSE)
NAME = re.compile(r"\b(std|Eigen)::(\w+)")


def by_name(table: dict[str, str], brings: dict[str, set[str]], folder: str) -> dict[str, set[str]]:
    """Of each name the headers any of which declares it."""
    declared: dict[str, set[str]] = {}
    for header, names in table.items():
        for name in names.split():
            declared.setdefault(name, set()).update({header, *brings.get(header, ())})
    return {name: {folder + header for header in headers} for name, headers in declared.items()}


DECLARED_IN = {"std": by_name(STANDARD, BRINGS, ""), "Eigen": by_name(EIGEN, EIGEN_BRINGS, "Eigen/")}


def sources(root: Path, folder: str) -> Iterator[Path]:
    found = (file for file in (root / folder).rglob("*") if file.suffix in (".hpp", ".cpp"))
    return (file for file in sorted(found) if not KNOWS_ITS_PEER.match(file.relative_to(root).as_posix()))


def public_headers(root: Path) -> Iterator[Path]:
    for layer in LAYERS:
        yield from sources(root, f"{layer}/include")


@cache
def code(file: Path) -> str:
    """The text without comments and strings; what #include names stays."""
    return TEXT.sub(lambda found: found[1] or "", file.read_text())


@cache
def included(file: Path) -> frozenset[str]:
    return frozenset(INCLUDE.findall(code(file)))


def against_direction(root: Path) -> Iterator[str]:
    for pattern, folders in FORBIDDEN:
        forbidden = re.compile(pattern)
        for file in (file for folder in folders for file in sources(root, folder)):
            for name in sorted(included(file)):
                if forbidden.match(name):
                    yield f"{file.relative_to(root)}: includes {name}, against the direction of dependence"


def engine_names(root: Path) -> Iterator[str]:
    for header in public_headers(root):
        for name in sorted(set(ENGINE_NAME.findall(code(header)))):
            yield f"{header.relative_to(root)}: names '{name}' in a public header"


def reached(header: Path, folders: list[Path]) -> set[str]:
    """What a header includes, itself or through headers of ours."""
    names: set[str] = set()
    left = [header]
    while left:
        fresh = included(left.pop()) - names
        names |= fresh
        left += [folder / name for name in fresh for folder in folders if (folder / name).exists()]
    return names


def missing_includes(root: Path) -> Iterator[str]:
    folders = [root / layer / "include" for layer in LAYERS]
    for header in public_headers(root):
        where = header.relative_to(root)
        names = reached(header, folders)
        for library, name in sorted(set(NAME.findall(code(header)))):
            wanted = DECLARED_IN[library].get(name)
            if wanted is None:
                yield f"{where}: {library}::{name} is not in the table of tools/includes.py"
            elif not wanted & names:
                yield f"{where}: {library}::{name} needs one of: {', '.join(sorted(wanted))}"
        if re.search(r"\bboost::", code(header)) and not any(name.startswith("boost/") for name in included(header)):
            yield f"{where}: boost:: needs an include of Boost in this header"


def violations(root: Path) -> list[str]:
    return [*against_direction(root), *engine_names(root), *missing_includes(root)]


def main() -> int:
    found = violations(Path(sys.argv[1]).resolve())
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

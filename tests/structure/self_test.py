#!/usr/bin/env python3
"""The checks of this folder notice what they are for."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import check_dependencies
import check_headers
import check_kernel_symbols
import check_linked
import check_owned_vectors
import check_reference
import check_silence
import check_sizes
import libraries

RULES = libraries.read_rules("""
core:  | immintrin.h
linalg: core   # comment
energies: linalg
""")


class Folder(unittest.TestCase):
    """A libs/ of its own, in a temporary directory."""

    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp())
        self.old_root, libraries.ROOT = libraries.ROOT, self.root

    def tearDown(self):
        libraries.ROOT = self.old_root
        shutil.rmtree(self.root)

    def faults(self, name, cmake, **files):
        folder = self.root / "libs" / name
        for part in ("include", "src", "tests"):
            (folder / part).mkdir(parents=True)
            (folder / part / "x.cpp").write_text(files.get(part, ""))
        (folder / "CMakeLists.txt").write_text(cmake)
        return (check_dependencies.check_components(name, folder, RULES) +
                check_dependencies.check_includes(name, folder, RULES))

    def test_a_sound_library_passes(self):
        self.assertEqual(self.faults(
            "linalg", 'isostretch_add_library(linalg\n  COMPONENTS core\n  PACKAGES "X COMPONENTS CXX" "Y")\n',
            include="#include <isostretch/core/error.hpp>\n#include <Eigen/Core>\n#include <vector>\n"), [])

    def test_an_include_upwards_is_a_fault(self):
        faults = self.faults("linalg", "isostretch_add_library(linalg COMPONENTS core)",
                             include="#include <isostretch/core/error.hpp>\n",
                             src="// x\n#include <isostretch/energies/registry.hpp>\n")
        self.assertEqual(faults, ["libs/linalg/src/x.cpp:2: linalg may not include isostretch/energies/registry.hpp"])

    def test_third_parties_are_stated_and_private(self):
        self.assertIn("core may not include <omp.h>",
                      self.faults("core", "isostretch_add_library(core)", src="#include <omp.h>\n")[0])

    def test_components_must_be_the_rules(self):
        faults = self.faults("energies", "isostretch_add_library(energies COMPONENTS linalg core)",
                             include="#include <isostretch/linalg/svd.hpp>\n")
        self.assertEqual(len(faults), 1)

    def test_a_component_nobody_includes_is_a_fault(self):
        self.assertEqual(len(self.faults("linalg", "isostretch_add_library(linalg COMPONENTS core)")), 1)

    def test_tests_may_use_test_components_only(self):
        cmake = "isostretch_add_library(core SOURCES a.cpp TEST_COMPONENTS linalg)"
        self.assertEqual(self.faults("core", cmake, tests="#include <isostretch/linalg/svd.hpp>\n"), [])

    def test_commented_includes_do_not_count(self):
        self.assertEqual(self.faults("core", "isostretch_add_library(core)",
                                     src="// #include <omp.h>\n/*\n#include <omp.h>\n*/\n"), [])


class Silence(unittest.TestCase):
    def test_prints_and_exits_are_noticed(self):
        for line in ("std::cout << 1;", "printf(\"x\");", "std::fprintf(stderr, \"x\");", "exit(1);", "std::abort();",
                     "assert(x);", "fputs(text, stdout);"):
            self.assertEqual(len(check_silence.faults_in("int a;\n" + line)), 1, line)

    def test_the_rest_is_not(self):
        for line in ("std::snprintf(b, n, f);", "// printf(x)", 'text = "exit(1)";', "on_exit(x);", "fprintf(file_, f);",
                     "solver.abort();", "static_assert(true);", "const int a = 1'000; // exit(1)"):
            self.assertEqual(check_silence.faults_in(line), [], line)


class OwnedVectors(unittest.TestCase):
    def test_functions_of_aligned_matrices_are_noticed(self):
        vector = "Eigen::Matrix<double, -1, 1, {}, -1, 1>"
        storage = "Eigen::DenseStorage<int, -1, 1, -1, {}>::resize(long, long, long)"
        resize = "Eigen::PlainObjectBase<" + vector + " >::resize(long)"
        bad = [("W", resize.format(0)), ("V", storage.format(1))]
        self.assertEqual(len(check_owned_vectors.faults_in(bad)), 2)
        good = [("W", resize.format(2)), ("W", storage.format(3)), ("T", resize.format(0)),
                ("W", "isostretch_" + resize.format(0)), ("W", "void use<" + vector.format(0) + " >()")]
        self.assertEqual(check_owned_vectors.faults_in(good), [])
        limited = "Eigen::PlainObjectBase<Eigen::Matrix<double, -1, 1, 0, 4096, 1> >::resize(long, long)"
        self.assertEqual(check_owned_vectors.faults_in([("W", limited)]), [])
        for sizes in ("-1, 3, 0, -1, 3", "3, -1, 0, 3, -1", "-1, -1, 0, -1, -1"):
            owner = f"Eigen::PlainObjectBase<Eigen::Matrix<double, {sizes}> >::resize(long, long)"
            self.assertEqual(len(check_owned_vectors.faults_in([("W", owner)])), 1)


class Reference(unittest.TestCase):
    def test_warnings_name_symbols(self):
        root = str(libraries.ROOT)
        log = (f"{root}/libs/a/include/x.hpp:3: warning: Member y is not documented.\n"
               f"{root}/libs/b/include/z.hpp:1: warning: first line\n  second line\n")
        self.assertEqual(len(check_reference.read_warnings(log)), 3)

    def test_fragments_are_noticed(self):
        text = "/// What it is.\nint a;\n/// Returns what\n/// of it.\nint b;  ///< of a\nint c;  ///< The number.\n"
        self.assertEqual([number for number, _ in check_reference.fragments(text)], [1, 5])

    def test_namespaces_must_be_documented(self):
        headers = ["namespace isostretch::a {\n", "namespace isostretch::b {\n"]
        self.assertEqual(check_reference.undocumented_namespaces(headers, "/// @namespace isostretch::a\n"), ["isostretch::b"])

    def test_an_undocumented_symbol_is_noticed(self):
        doxygen = shutil.which("doxygen") or self.skipTest("no doxygen")
        template = (libraries.ROOT / "docs" / "Doxyfile.in").read_text()
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "x.hpp").write_text("namespace n {\n/// Returns 1.\nint known();\nint unknown();\n"
                                          "namespace detail { int hidden(); }\n"
                                          "inline namespace ISOSTRETCH_ISA { int templated(); }\n}\n")
            (folder / "pages.dox").write_text("/// @namespace n\n/// A namespace.\n")
            values = {"ISOSTRETCH_REFERENCE_INPUT": name, "ISOSTRETCH_REFERENCE_DIR": name, "ISOSTRETCH_REFERENCE_STRIP": name,
                      "PROJECT_SOURCE_DIR": str(libraries.ROOT)}
            text = re.sub(r"@(\w+)@", lambda m: values.get(m.group(1), "x"), template).replace("*.hpp\n", "*.hpp *.dox\n", 1)
            (folder / "Doxyfile").write_text(text)
            warnings = check_reference.read_warnings(check_reference.run_doxygen(doxygen, folder / "Doxyfile"))
        self.assertEqual(len(warnings), 2, warnings)
        self.assertIn("unknown()", warnings[0] + warnings[1])
        self.assertIn("Member templated() (function) of namespace n is", warnings[0] + warnings[1])


class KernelSymbols(unittest.TestCase):
    def test_a_shared_inline_function_is_noticed(self):
        compiler = shutil.which("c++") or self.skipTest("no compiler")
        source = """
            inline int leaked(int x) { return x + 1; }
            namespace lib { inline namespace v4 { template <class T> T own(T x) { return x; } } }
            namespace lib::kernels_v4 { extern const int table; const int table = 1;
              int entry(int x) { return lib::own(leaked(x)); } }
            static int hidden(int x) { return x; }
            namespace lib::kernels_v4 { int other(int x) { return hidden(x); } }"""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "k.v4.cpp.o"
            subprocess.run([compiler, "-O0", "-c", "-x", "c++", "-", "-o", str(path)], input=source, text=True, check=True)
            names = [name for _, name in check_kernel_symbols.demangled_symbols(path)
                     if not check_kernel_symbols.belongs_to("v4", name)]
        self.assertEqual(names, ["leaked(int)"])


class Headers(unittest.TestCase):
    TEXTS = {"isostretch/a.hpp": "#pragma once\n\n// first\n#include <isostretch/b.hpp>\n#include <vector>\n",
             "isostretch/b.hpp": "#pragma once\n#include <Eigen/Core>\n#include <isostretch/c.hpp>\n",
             "isostretch/c.hpp": "#pragma once\n#include <vector>\n"}

    def test_only_what_stands_before_all_else_is_proven_by_another(self):
        self.assertEqual(check_headers.proven_by_others(self.TEXTS), {"isostretch/b.hpp"})
        self.assertIsNone(check_headers.first_include("#define X\n#include <isostretch/b.hpp>\n"))

    def test_eigen_is_precompiled_for_those_that_reach_it(self):
        self.assertEqual(check_headers.precompiled_for("isostretch/a.hpp", self.TEXTS), "Eigen/Core")
        self.assertIsNone(check_headers.precompiled_for("isostretch/c.hpp", self.TEXTS))

    def test_a_header_that_needs_another_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "x.hpp").write_text("inline std::vector<int> f();\n")
            header, code, errors = check_headers.compile_header("x.hpp", ["c++", "-std=c++20", f"-I{folder}"])
        self.assertNotEqual(code, 0)
        self.assertIn("vector", errors)


class Sizes(unittest.TestCase):
    def test_long_files_and_large_apps_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for part in ("libs", "tests", "tools", "apps/small", "apps/large"):
                (root / part).mkdir(parents=True)
            (root / "apps/small/main.cpp").write_text("\n" * 400)
            for name in "ab":
                (root / "apps/large" / f"{name}.cpp").write_text("\n" * 301)
            (root / "libs/x.hpp").write_text("\n" * 401)
            self.assertEqual(check_sizes.long_files(root), (["libs/x.hpp has 401 lines, more than 400"], 4))
            faults = check_sizes.large_apps(root)
            self.assertEqual(len(faults), 1)
            self.assertIn("apps/large has 602 lines", faults[0])


class Linked(unittest.TestCase):
    def test_rivals_are_named(self):
        listing = "\tlinux-vdso.so.1 (0x1)\n\tlibipopt.so.1 => /usr/lib/libipopt.so.1 (0x2)\n\tlibm.so.6 => x\n"
        self.assertEqual(check_linked.rivals_in(listing), ["libipopt.so.1"])
        self.assertEqual(check_linked.rivals_in("\tlibcholmod.so.3 => x\n"), [])


if __name__ == "__main__":
    sys.exit(0 if unittest.main(exit=False, verbosity=1).result.wasSuccessful() else 1)

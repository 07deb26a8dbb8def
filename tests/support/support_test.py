#!/usr/bin/env python3
"""Test programs skip cases visibly, and CTest gets an entry for every case.

support_test.py <isostretch_support_tests> <cmake> <IsostretchDiscoverTests.cmake>
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, CMAKE, DISCOVER = sys.argv[1:4]
CASES = ["passes", "fails; as it should", "reads, and passes", "reads two files"]
CONDITIONAL = ["reads, and passes", "reads two files"]


class Support(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "data/folder").mkdir(parents=True)

    def write(self, *names):
        for name in names:
            (self.folder / "data" / name).write_text("x")

    def run_cases(self, *filters):
        environment = dict(os.environ, ISOSTRETCH_TEST_DATA=str(self.folder / "data"))
        return subprocess.run([PROGRAM, *filters], env=environment, capture_output=True, text=True)

    def discover(self, *definitions):
        output = self.folder / "cases.cmake"
        run = subprocess.run([CMAKE, f"-DPROGRAM={PROGRAM}", "-DPREFIX=p", f"-DOUTPUT={output}", *definitions, "-P", DISCOVER],
                             capture_output=True, text=True)
        return run, output

    def test_without_data_the_code_is_that_of_a_skipped_test(self):
        run = self.run_cases("--test-case=reads\\, and passes")
        self.assertEqual(run.returncode, 77)
        self.assertIn("folder/there.txt is not there", run.stdout)

    def test_with_data_the_case_runs(self):
        self.write("folder/there.txt")
        run = self.run_cases("--test-case=reads\\, and passes")
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("assertions: 1 | 1 passed", run.stdout)

    def test_all_files_have_to_be_there(self):
        self.write("other.txt")
        self.assertEqual(self.run_cases("--test-case=reads two files").returncode, 77)
        self.write("folder/there.txt")
        self.assertEqual(self.run_cases("--test-case=reads two files").returncode, 0)

    def test_a_failure_is_a_failure_whatever_was_skipped(self):
        self.assertEqual(self.run_cases().returncode, 1)

    def test_what_needs_nothing_is_not_skipped(self):
        run = self.run_cases("--test-suite-exclude=conditional", "--test-case-exclude=fails*")
        self.assertEqual(run.returncode, 0)

    def test_every_case_is_an_entry_that_runs_that_case(self):
        run, output = self.discover("-DPROPERTIES=SKIP_RETURN_CODE;77")
        self.assertEqual(run.returncode, 0, run.stderr)
        entries = self.entries(output)
        self.assertEqual(entries, {f"p.{case}" for case in CASES})

    def test_only_the_cases_of_a_suite(self):
        run, output = self.discover("-DSUITE=conditional", "-DPROPERTIES=SKIP_RETURN_CODE;77")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(self.entries(output), {f"p.{case}" for case in CONDITIONAL})
        run, output = self.discover("-DSUITE=of nothing", "-DPROPERTIES=")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(output.read_text(), "")

    # Runs them by CTest, which tells each by how it ended.
    def entries(self, output):
        (self.folder / "CTestTestfile.cmake").write_text(output.read_text())
        self.write("folder/there.txt")
        (self.folder / "data/other.txt").unlink(missing_ok=True)
        environment = dict(os.environ, ISOSTRETCH_TEST_DATA=str(self.folder / "data"))
        ctest = pathlib.Path(CMAKE).with_name("ctest")
        lines = subprocess.run([ctest], cwd=self.folder, env=environment, capture_output=True, text=True).stdout.splitlines()
        expected = {"passes": "Passed", "fails; as it should": "***Failed", "reads, and passes": "Passed",
                    "reads two files": "***Skipped"}
        found = set()
        for case, how in expected.items():
            line = [line for line in lines if "Test #" in line and f"p.{case} " in line]
            if line:
                self.assertIn(how, line[0])
                found.add(f"p.{case}")
        return found


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

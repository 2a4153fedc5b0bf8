#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""release_files_test.py BUILD: the bill of materials and the sums of the program that was just built."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(sys.argv.pop(1))


def run(*words):
    return subprocess.run([str(ROOT / "cmake/release-files"), *map(str, words)], text=True, capture_output=True,
                          check=False)


class ReleaseFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.out = Path(cls.scratch.name) / "out"
        done = run(BUILD, cls.out, ROOT / "LICENSE", ROOT / "README.md")
        assert done.returncode == 0, done.stderr
        cls.bill_file = next(cls.out.glob("*.cdx.json"))
        cls.bill = json.loads(cls.bill_file.read_text(encoding="utf-8"))

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_the_bill_is_cyclonedx_of_this_version(self):
        self.assertEqual(self.bill["bomFormat"], "CycloneDX")
        self.assertEqual(self.bill["specVersion"], "1.5")
        self.assertRegex(self.bill["serialNumber"], r"^urn:uuid:[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$")
        version = subprocess.run([str(BUILD / "cli/gonogo"), "--version"], text=True, capture_output=True,
                                 check=True).stdout.split()[1]
        top = self.bill["metadata"]["component"]
        self.assertEqual((top["name"], top["version"]), ("gonogo", version))
        self.assertEqual(self.bill_file.name, "gonogo-%s.cdx.json" % version)

    def test_every_component_has_what_readers_of_bills_need(self):
        for part in self.bill["components"]:
            self.assertEqual(part["type"], "library")
            self.assertRegex(part["purl"], r"^pkg:deb/debian/[a-z0-9+.-]+@[^@?]+\?arch=[a-z0-9]+$")
            self.assertTrue(part["version"])
            self.assertTrue(all(licence["license"]["name"] for licence in part["licenses"]))
            self.assertTrue(part["licenses"])
        references = [part["bom-ref"] for part in self.bill["components"]]
        self.assertEqual(len(set(references)), len(references))
        self.assertEqual(self.bill["dependencies"][0]["dependsOn"], references)

    def test_what_the_sources_include_is_in_it(self):
        uses = {part["name"]: {p["name"]: p["value"] for p in part["properties"]}["gonogo:use"]
                for part in self.bill["components"]}
        for header_only in ("libcgal-dev", "nlohmann-json3-dev", "libcli11-dev"):
            self.assertEqual(uses[header_only], "compiled in")
        self.assertTrue(any(re.match(r"libboost[0-9.]+-dev$", name) for name in uses))
        self.assertIn("libgmp-dev", uses)
        # What tests alone use is no part of the program.
        for of_tests in ("libgtest-dev", "librapidcheck-dev", "libbenchmark-dev"):
            self.assertNotIn(of_tests, uses)

    def test_every_library_that_the_program_needs_is_in_it(self):
        needed = re.findall(r"NEEDED\s+(\S+)", subprocess.run(
            ["objdump", "-p", str(BUILD / "cli/gonogo")], text=True, capture_output=True, check=True).stdout)
        names = " ".join(part["name"] for part in self.bill["components"]).replace("-", "")
        for library in needed:
            if library.startswith(("libgmp", "libfmt", "libsimdjson", "libmpfr")):
                self.assertIn(library.split(".")[0], names)
        self.assertTrue(needed)

    def test_versions_are_those_that_are_installed(self):
        for part in self.bill["components"]:
            installed = subprocess.run(["dpkg-query", "-W", "-f=${Version}", part["bom-ref"][len("deb:"):]], text=True,
                                       capture_output=True, check=True).stdout
            self.assertEqual(part["version"], installed)

    def test_sums_are_true_and_a_changed_file_is_noticed(self):
        for name in ("LICENSE", "README.md"):
            (self.out / name).write_bytes((ROOT / name).read_bytes())
        check = ["sha256sum", "--check", "--strict", "SHA256SUMS"]
        self.assertEqual(subprocess.run(check, cwd=self.out, capture_output=True, check=False).returncode, 0)
        self.assertEqual(len((self.out / "SHA256SUMS").read_text().splitlines()), 3)
        with open(self.out / "README.md", "a", encoding="utf-8") as file:
            file.write("more\n")
        self.assertNotEqual(subprocess.run(check, cwd=self.out, capture_output=True, check=False).returncode, 0)

    def test_the_same_build_gives_the_same_bytes(self):
        again = Path(self.scratch.name) / "again"
        self.assertEqual(run(BUILD, again).returncode, 0)
        self.assertEqual((again / self.bill_file.name).read_bytes(), self.bill_file.read_bytes())

    def test_wrong_use_is_told(self):
        empty = Path(self.scratch.name) / "empty"
        empty.mkdir(exist_ok=True)
        for words, sentence in [((), "usage"), ((BUILD,), "usage"),
                                ((empty, self.out), "build the program first"),
                                ((BUILD, self.out, "/nowhere"), "is no file"),
                                ((BUILD, self.out, ROOT / "README.md", ROOT / "docs/README.md"), "two files are named"),
                                ((BUILD, ROOT / "LICENSE" / "x"), "cannot be made")]:
            done = run(*words)
            self.assertEqual(done.returncode, 2, words)
            self.assertIn(sentence, done.stderr)


if __name__ == "__main__":
    if not os.path.isdir("/var/lib/dpkg/info"):
        print("SKIPPED: no bill is written, because this is no Debian")
        sys.exit(0)
    unittest.main()

"""The patches that put faults into the reference: all fit, and no fault is in the library."""

from __future__ import annotations

import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest
from minkref.reports.evidence.planted_faults.faults import FEWEST_OF_LIST, planted

ROOT = Path(__file__).resolve().parents[2]
LIBRARY = ("reference", "formats", "certify", "bindings", "oracle", "minkref", "tools/cmake")
SOURCE = "int sum(int a, int b) {\n  return a + b;\n}\n\nint one() { return 1; }\n"
PATCH = """\
wrong_sign: the difference for the sum

--- a/reference/sum.cpp
+++ b/reference/sum.cpp
@@ -1,3 +1,3 @@
 int sum(int a, int b) {
-  return a + b;
+  return planted(Fault::wrong_sign) ? a - b : a + b;
 }
"""


def test_each_fault_has_a_patch_and_each_patch_names_its_faults() -> None:
    header = (ROOT / "tests" / "planted" / "fault.hpp").read_text("utf-8")
    names = re.findall(r"\bX\((\w+)\)", header)
    by_patches = Counter(name for patch in planted.patches() for name in planted.names_of(patch))
    assert by_patches == Counter(names)
    assert list(planted.listed()) == names
    assert len(set(planted.listed().values())) == len(names)
    for folder, fewest in FEWEST_OF_LIST.items():
        assert len(planted.listed(folder)) >= fewest


@pytest.mark.parametrize("patch", planted.patches(), ids=lambda patch: patch.stem)
def test_patch_says_what_is_wrong_and_puts_in_what_it_names(patch: Path) -> None:
    names = planted.names_of(patch)
    assert list(planted.described(patch)) == names
    assert all(planted.described(patch).values())
    assert set(re.findall(r"Fault::(\w+)", patch.read_text("utf-8"))) == set(names)


def test_all_patches_together_fit_the_present_sources() -> None:
    texts = planted.patched(planted.patches())
    found = set(re.findall(r"planted\(Fault::(\w+)\)", "".join(texts.values())))
    assert found == set(planted.listed())


def test_no_fault_is_left_in_the_library() -> None:
    sources = [p for room in LIBRARY for p in (ROOT / room).rglob("*") if p.is_file()]
    texts = [p for p in (*sources, ROOT / "CMakeLists.txt") if p.suffix in (".cpp", ".hpp", ".txt")]
    assert len(texts) > 500
    hook = re.compile(r"\bplanted\(|\bfault\.hpp|MINKREF_FAULT")
    assert [path for path in texts if hook.search(path.read_text("utf-8"))] == []


class Checkout:
    """A small one, with the tool, a source and a fault of it."""

    def __init__(self, root: Path) -> None:
        self.root, self.tool = root, root / "tools" / "scripts" / "planted.py"
        self.source = self.write("reference/sum.cpp", SOURCE)
        self.patch = self.write("tests/planted/plane/wrong_sign.patch", PATCH)
        self.write("reference/other.cpp", "")
        self.write("tools/scripts/planted.py", Path(planted.__file__).read_text("utf-8"))

    def write(self, name: str, text: str) -> Path:
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def run(self, *words: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, str(self.tool), *words]
        return subprocess.run(command, cwd=self.root, capture_output=True, text=True, check=False)

    def copied(self) -> dict[str, str]:
        done = self.run("copy", "build/copy")
        assert done.returncode == 0, done.stderr
        folder = self.root / "build" / "copy" / "reference"
        return {path.name: path.read_text("utf-8") for path in folder.iterdir()}


@pytest.fixture
def checkout(tmp_path: Path) -> Checkout:
    return Checkout(tmp_path)


def test_copy_has_the_faults_and_writes_only_what_has_changed(checkout: Checkout) -> None:
    hooked = SOURCE.replace("a + b", "planted(Fault::wrong_sign) ? a - b : a + b")
    switch = '#include "tests/planted/fault.hpp"\n'
    assert checkout.copied() == {"sum.cpp": switch + hooked, "other.cpp": ""}
    file = checkout.root / "build" / "copy" / "reference" / "sum.cpp"
    before = file.stat().st_mtime_ns
    checkout.source.with_name("other.cpp").unlink()
    assert checkout.copied() == {"sum.cpp": switch + hooked}
    assert file.stat().st_mtime_ns == before
    checkout.source.write_text(f"// A sum.\n{SOURCE}", encoding="utf-8")
    assert checkout.copied() == {"sum.cpp": f"{switch}// A sum.\n{hooked}"}
    checkout.patch.unlink()
    assert checkout.copied() == {"sum.cpp": f"// A sum.\n{SOURCE}"}


@pytest.mark.parametrize(
    "source", [SOURCE.replace("a + b", "b + a"), f"\n{SOURCE}{SOURCE}"], ids=["changed", "twice"]
)
def test_patch_that_does_not_fit_is_named_with_its_mend(checkout: Checkout, source: str) -> None:
    checkout.source.write_text(source, encoding="utf-8")
    done = checkout.run("copy", "build/copy")
    assert done.returncode == 1
    assert "wrong_sign.patch does not apply: reference/sum.cpp has these lines" in done.stderr
    assert "planted.py edit wrong_sign" in done.stderr
    assert "planted.py record wrong_sign" in done.stderr


def test_edit_and_record_renew_a_patch(checkout: Checkout) -> None:
    checkout.source.write_text(SOURCE.replace("a + b", "b + a"), encoding="utf-8")
    done = checkout.run("edit", "wrong_sign")
    assert "to be put in by hand: reference/sum.cpp has these lines 0 times" in done.stdout
    edited = checkout.root / "build" / "planted" / "wrong_sign" / "reference" / "sum.cpp"
    assert edited.read_text("utf-8") == checkout.source.read_text("utf-8")
    hooked = SOURCE.replace("a + b", "planted(Fault::wrong_sign) ? b - a : b + a")
    edited.write_text(hooked, encoding="utf-8")
    assert checkout.run("record", "wrong_sign").returncode == 0
    assert checkout.patch.read_text("utf-8").startswith(PATCH.partition("@@")[0])
    assert checkout.copied()["sum.cpp"].endswith(hooked)
    assert "edit wrong_sign` comes first" in checkout.run("record", "wrong_sign").stderr


def test_new_fault_is_named_with_its_folder_and_its_file(checkout: Checkout) -> None:
    done = checkout.run("edit", "no_one", "reference/sum.cpp")
    assert (done.returncode, "named with its folder" in done.stderr) == (1, True)
    assert checkout.run("edit", "plane/no_one", "reference/sum.cpp").returncode == 0
    edited = checkout.root / "build" / "planted" / "no_one" / "reference" / "sum.cpp"
    edited.write_text(SOURCE.replace("return 1", "return planted(Fault::no_one) ? 0 : 1"), "utf-8")
    assert checkout.run("record", "plane/no_one", "one is zero").returncode == 0
    assert checkout.patch.with_name("no_one.patch").read_text("utf-8").startswith("no_one: one is")
    assert checkout.copied()["sum.cpp"].count("planted(") == 2


def test_two_patches_of_the_same_lines_are_told(checkout: Checkout) -> None:
    other = checkout.patch.with_name("zero.patch")
    other.write_text(PATCH.replace("wrong_sign", "zero").replace("a - b", "0"), encoding="utf-8")
    done = checkout.run("copy", "build/copy")
    assert done.returncode == 1
    assert "zero.patch changes lines that another patch changes: join the two" in done.stderr

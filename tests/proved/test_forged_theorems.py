"""A theorem from somebody else: the recipe of docs/proved.md takes a true one, and no forged one,
though coqc takes each forged file by itself."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from minkref.cli.cli import run
from minkref.reports.evidence.certificates.checkers import ROOT

PROOFS = ROOT / "build" / "proofs"
SQUARE = "POLYGON((0 0, 1 0, 1 1, 0 1, 0 0))"
TRUE, FALSE = "(2#1, 2#1)", "(3#1, 3#1)"  # a corner of R
NEAR, FAR = "(1#1, 2#1)", "(2#1, 3#1)"  # points in the sum, and outside
STATED = re.compile(r"Theorem (\w+) :\n(.*?)(?=Proof\.)", re.DOTALL)
ENTRY = re.compile(r"^(?=\S)", re.MULTILINE)  # of a list of axioms: a line that is not indented
TRIVIAL = (
    'Definition in_all (n : nat) : Prop := True. Notation "a /\\ b" := (in_all 0) : type_scope.'
)
CLOSED = 'Goal True. idtac "Closed under the global context". exact I. Qed.'
LOOP = """Unset Guard Checking.
Fixpoint loop (n : nat) : False := loop n.
Set Guard Checking.
"""
HEAD = "From Proved Require Import Definitions Form.\nOpen Scope Q_scope.\n"
KNOWN = "Module ClassicalDedekindReals. Axiom sig_not_dec : False. End ClassicalDedekindReals.\n"
#: How a file states and proves a false sum: @ is the statement in the words of the page
FORGED = {
    "an axiom of a known name":
        KNOWN + "@Proof. destruct ClassicalDedekindReals.sig_not_dec. Qed.",
    "an axiom instead of the lemma":
        "Axiom form_is_right : forall A : Prop, A.\n@Proof. apply form_is_right. Qed.",
    "no guard": LOOP + "@Proof. destruct (loop 0). Qed.",
    "words of another meaning": TRIVIAL + "\n@Proof. intros. exact I. Qed.",
    "another set_of, and what is printed": CLOSED + """
Definition has_components (S : point -> Prop) (n : nat) := True.
Definition has_holes (S : point -> Prop) (n : nat) := True.
Definition is_canonical (S : point -> Prop) (r : list (polygon point)) := True.
Definition set_of (r : rings point) (x : point) : Prop := True.
@Proof.
  intros. repeat split. intros _. exists x, (0, 0)%R. repeat split. destruct x as [a b].
  unfold add, scale; simpl. unfold s. f_equal; unfold Q2R; simpl; field.
Qed.""",
    "the statement is taken back":
        "@Abort.\nTheorem this_is_the_sum : True. Proof. exact I. Qed.",
}  # fmt: skip
#: And of a point outside
FORGED_POINTS = {
    "another set_of": """
Definition set_of (r : rings point) (x : point) : Prop := False.
@Proof. intros s P Q' x (p & q & nowhere & _). exact nowhere. Qed.""",
    "another not": """
Notation "~ a" := (a -> True) : type_scope.
@Proof. intros s P Q' x there. exact I. Qed.""",
    "the statement is taken back":
        "@Abort.\nTheorem this_point_is_outside : True. Proof. exact I. Qed.",
}  # fmt: skip


def page(kind: str) -> str:
    """The reader's own file, as the page has it: of a sum; of a point outside, or inside."""
    text = (ROOT / "docs" / "proved.md").read_text(encoding="utf-8")
    of_sum, outside = re.findall(r"```coq\n(.*?)```", text, re.DOTALL)
    inside = outside.replace("~ ", "").replace("outside", "inside").replace(FAR, NEAR)
    return {"sum": str(of_sum), "outside": str(outside), "inside": str(inside)}[kind]


def words_of(own: str) -> str:
    """The statement of a reader's file."""
    return own.partition("Prop :=")[2].partition("From Theirs")[0]


@pytest.fixture
def coqc() -> str:
    found = shutil.which("coqc")
    if found is None or not (PROOFS / "Canonical.vo").exists():
        pytest.skip("coqc or the compiled proofs are absent: make proofs")
    return found


def compiled(coqc: str, folder: Path, name: str) -> subprocess.CompletedProcess[str]:
    command = [coqc, "-q", "-Q", str(PROOFS), "Proved", "-Q", ".", "Theirs", name]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def axioms(printed: str) -> set[str]:
    """The axioms that are printed last, each with its statement."""
    entries = ENTRY.split(printed.rpartition("Axioms:\n")[2])
    return {" ".join(entry.split()) for entry in entries if entry.strip()}


def is_believed(coqc: str, folder: Path) -> bool:
    """What the page has the reader look at, after the stranger's file is compiled."""
    ran = compiled(coqc, folder, "mine.v")
    known = axioms((PROOFS / "Axioms.log").read_text(encoding="utf-8"))
    return ran.returncode == 0 and axioms(ran.stdout) <= known


@pytest.mark.usefixtures("proved")
@pytest.mark.parametrize(
    ("kind", "options", "true", "false"),
    [
        ("sum", [], TRUE, FALSE),
        ("outside", ["--point", "2,3"], FAR, NEAR),
        ("inside", ["--point", "1,2"], NEAR, FAR),
    ],
)
def test_the_recipe_takes_a_theorem_of_certify(
    coqc: str, tmp_path: Path, kind: str, options: list[str], true: str, false: str
) -> None:
    (tmp_path / "square.wkt").write_text(SQUARE, encoding="utf-8")
    square, theirs, own = str(tmp_path / "square.wkt"), tmp_path / "sum.v", page(kind)
    out = ["-o", str(tmp_path / "it.cert.json"), "--theorem", str(theirs)]
    assert run(["certify", square, square, "--scale", "1", *options, *out]) == 0
    ran = compiled(coqc, tmp_path, "sum.v")
    assert ran.returncode == 0, ran.stderr
    (tmp_path / "mine.v").write_text(own, encoding="utf-8")
    assert is_believed(coqc, tmp_path)
    text = theirs.read_text(encoding="utf-8")
    ((name, stated),) = STATED.findall(text)
    assert stated.split() == words_of(own).split()  # the page has the statement's words
    assert f"sum.{name}" in own and "Checker" not in text.partition("Proof.")[0]
    assert true in own
    (tmp_path / "mine.v").write_text(own.replace(true, false), encoding="utf-8")
    assert not is_believed(coqc, tmp_path)


@pytest.mark.parametrize(
    ("of", "kind"),
    [*(("sum", kind) for kind in FORGED), *(("outside", kind) for kind in FORGED_POINTS)],
)
def test_the_recipe_takes_no_forged_theorem(coqc: str, tmp_path: Path, of: str, kind: str) -> None:
    if of == "sum":
        own, forged = page(of).replace(TRUE, FALSE), FORGED[kind]
    else:
        own, forged = page(of).replace(FAR, NEAR), FORGED_POINTS[kind]
    (name,) = re.findall(r"believed : claimed := sum\.(\w+)\.", own)
    words = forged.replace("@", f"Theorem {name} :{words_of(own)}")
    (tmp_path / "sum.v").write_text(HEAD + words, encoding="utf-8")
    (tmp_path / "mine.v").write_text(own, encoding="utf-8")
    ran = compiled(coqc, tmp_path, "sum.v")
    assert ran.returncode == 0, ran.stderr
    assert not is_believed(coqc, tmp_path), kind

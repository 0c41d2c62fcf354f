#!/bin/bash
# proofs.sh: the proofs of oracle/proved and the checker that is extracted from them, in
# build/proofs. Installs Coq and OCaml as set_up.sh installs its packages; compiles every proof, has
# coqchk follow them again, prints the axioms, and stops with 1 where there is another one than
# those below. Does nothing where nothing has changed.
set -euo pipefail
cd "$(dirname "$0")/.."
rooms=(Definitions Sums Crossings Fans Curves Unions Checker Rational Cancellation Bodies Scaling
  Trees Theorems Axioms Extract)
programs=(failure json sha256 inflate reading checker checked elaborate theorem claims main)
# The classical real numbers of Coq's library, and functional extensionality.
known="Coq.Logic.FunctionalExtensionality.functional_extensionality_dep
Coq.Reals.ClassicalDedekindReals.sig_not_dec
Coq.Reals.ClassicalDedekindReals.sig_forall_dec
Coq.Logic.Classical_Prop.classic"

say() { echo "minkref: $*"; }
packages=()
while read -r package command; do
  [[ $command != - ]] && command -v "$command" >/dev/null && continue
  packages+=("$package")
done <<'LIST'
coq coqc
ocaml-nox ocamlopt
ocaml-findlib ocamlfind
libzarith-ocaml-dev -
LIST
scripts/require_packages.sh "${packages[@]}"

mkdir -p build/proofs build/stamps
exec 9>build/stamps/proofs.lock
flock 9
sources_of() { cat oracle/proved/*.v oracle/proved/driver/*.ml scripts/proofs.sh; }
key=$({ coqc --version; ocamlfind ocamlopt -version; sources_of; } | sha256sum | cut -d' ' -f1)
program=build/proofs/minkref-check-proved
if [[ -f build/stamps/proofs && $(<build/stamps/proofs) == "$key" && -x $program ]]; then
  cat build/proofs/axioms.txt
  say "the proofs have not changed: $program"
  exit 0
fi
rm -rf build/proofs/* build/stamps/proofs
cp oracle/proved/*.v oracle/proved/driver/*.ml build/proofs/
cd build/proofs

began=$SECONDS
if grep -nEw 'Admitted|admit|Axiom|Axioms|Parameter|Parameters|Conjecture|Hypothesis|Variable' ./*.v |
  grep -vE '^./(Theorems.v:[0-9]+:(Variable|Hypothesis) |Axioms.v:)'; then
  say "a proof has a gap" >&2
  exit 1
fi
for room in "${rooms[@]}"; do
  coqc -q -Q . Proved "$room.v" >"$room.log" || {
    say "$room.v does not hold" >&2
    exit 1
  }
done
say "${#rooms[@]} files of proofs and $(cat ./*.v | wc -l) lines are compiled, $((SECONDS - began)) s"
coqchk -silent -o -Q . Proved Proved.Theorems >coqchk.txt 2>&1 || {
  cat coqchk.txt >&2
  exit 1
}
say "coqchk has followed them again, $((SECONDS - began)) s"
found=$(sed -n '/^\* Axioms:/,/^\* Constants/p' coqchk.txt | grep -E '^    ' | sed 's/ //g' || true)
others=$(grep -vxF "$known" <<<"$found" || true)
if [[ -n $others ]] || [[ $(grep -c '<none>' coqchk.txt) != 3 ]]; then
  cat coqchk.txt >&2
  say "there are axioms that are not known, or unsafe definitions" >&2
  exit 1
fi
{
  echo "The theorems sum_is_right and point_is_right rest on:"
  sed -n 's/^\([A-Z][A-Za-z.]*[a-z_]*\)$/  \1/p' Axioms.log | sort -u
  echo "All that they use of Coq's library rests on:"
  while read -r axiom; do echo "  $axiom"; done <<<"$found"
} | grep -v '  Axioms' >axioms.txt
cat axioms.txt

sources=()
for part in "${programs[@]}"; do
  [[ $part == checker ]] && sources+=(checker.mli)
  sources+=("$part.ml")
done
ocamlfind ocamlopt -O3 -inline 200 -package zarith,unix -linkpkg -w +a-4-9-39-40-41-42-44-45-70 \
  "${sources[@]}" -o minkref-check-proved >ocaml.log 2>&1 || {
  cat ocaml.log >&2
  exit 1
}
cd ../..
echo "$key" >build/stamps/proofs
say "$program, $((SECONDS - began)) s"
if [[ -x .venv/bin/python ]]; then .venv/bin/python scripts/link_package.py; fi

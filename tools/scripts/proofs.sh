#!/bin/bash
# proofs.sh: the proofs of oracle/proved and the checker that is extracted from them, in
# build/proofs. Installs Coq and OCaml as set_up.sh installs its packages; compiles every proof, has
# coqchk follow them again, prints the axioms, and stops with 1 where there is another one than
# those below. What has not changed is not done again.
set -euo pipefail
cd "$(dirname "$0")/../.."
programs=(failure json text sha256 reading rings checker checked classes pieces elaborate moving
  faces bodies theorem point_theorem intervals cells ways hits paths claims questions main)
# The classical real numbers of Coq's library, and functional extensionality.
known="Coq.Logic.FunctionalExtensionality.functional_extensionality_dep
Coq.Reals.ClassicalDedekindReals.sig_not_dec
Coq.Reals.ClassicalDedekindReals.sig_forall_dec
Coq.Logic.Classical_Prop.classic"

say() { echo "minkref: $*"; }
stop() {
  say "$1" >&2
  exit 1
}
key_of() { sha256sum | cut -d' ' -f1; }
fresh() { [[ -f build/stamps/$1 && $(<"build/stamps/$1") == "$2" ]]; }

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
tools/scripts/require_packages.sh "${packages[@]}"

mkdir -p build/proofs build/stamps
exec 9>build/stamps/proofs.lock
flock 9
began=$SECONDS

# 1. The proofs.
if grep -nEw 'Admitted|admit|Axiom|Parameter|Parameters|Conjecture' oracle/proved/*/*.v; then
  stop "a proof has a gap"
fi
compile() (
  cd build/proofs
  local files=(*.v)
  {
    echo "all: ${files[*]/%.v/.vo}"
    printf '%s\n' '%.vo: %.v' $'\t@coqc -q -Q . Proved $< >$*.log || { echo "$< does not hold"; exit 1; }'
    coqdep -Q . Proved "${files[@]}"
  } >rules
  make --silent -j "$(nproc)" -f rules all >make.log 2>&1 || stop "$(<make.log)"
  say "${#files[@]} files, $(cat ./*.v | wc -l) lines: compiled, $((SECONDS - began)) s"
  coqchk -silent -o -Q . Proved Proved.Axioms >coqchk.txt 2>&1 || {
    cat coqchk.txt >&2
    exit 1
  }
  say "coqchk has followed them again, $((SECONDS - began)) s"
  found=$(sed -n '/^\* Axioms:/,/^\* Constants/p' coqchk.txt | grep -E '^    ' | sed 's/ //g')
  others=$(grep -vxF "$known" <<<"$found" || true)
  if [[ -n $others || $(grep -c '<none>' coqchk.txt) != 3 ]]; then
    cat coqchk.txt >&2
    stop "there are axioms that are not known, or unsafe definitions"
  fi
  {
    echo "The theorems rest on:"
    grep -oE '^[A-Z][A-Za-z_]*\.[a-z_]+' Axioms.log | sort -u | sed 's/^/  /'
    echo "All that they use of Coq's library rests on:"
    sed 's/^/  /' <<<"$found"
  } >axioms.txt
)
key=$({ coqc --version; cat oracle/proved/*/*.v tools/scripts/proofs.sh; } | key_of)
if ! fresh proofs "$key"; then
  rm -rf build/proofs/* build/stamps/proofs build/stamps/proved-checker
  cp oracle/proved/*/*.v build/proofs/
  compile
  echo "$key" >build/stamps/proofs
fi
cat build/proofs/axioms.txt

# 2. The checker.
build() (
  cd build/proofs
  sources=()
  for part in "${programs[@]}"; do
    [[ -f $part.mli ]] && sources+=("$part.mli")
    sources+=("$part.ml")
  done
  ocamlfind ocamlopt -O3 -inline 200 -package zarith,unix -linkpkg -w +a-4-9-39-40-41-42-44-45-70 \
    "${sources[@]}" -o minkref-check-proved >ocaml.log 2>&1 || {
    cat ocaml.log >&2
    exit 1
  }
)
key=$({ echo "$key"; ocamlfind ocamlopt -version; cat oracle/proved/driver/*.ml*; } | key_of)
if ! fresh proved-checker "$key" || [[ ! -x build/proofs/minkref-check-proved ]]; then
  cp oracle/proved/driver/*.ml* build/proofs/
  build
  echo "$key" >build/stamps/proved-checker
  if [[ -x .venv/bin/python ]]; then .venv/bin/python tools/scripts/link_package.py; fi
fi
say "build/proofs/minkref-check-proved, $((SECONDS - began)) s"

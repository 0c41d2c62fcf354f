#!/bin/bash
# verify_in_ci.sh: the step of action.yml. Reads TARGETS, SECONDS_GIVEN, SEED, BASELINE, ARGUMENTS and REPORT; writes the
# report, JUnit XML and SARIF to the folder REPORT, and the summary to GITHUB_STEP_SUMMARY where that is set.
# TARGETS and ARGUMENTS are split at spaces and ends of lines. An empty variable, TARGETS too, leaves its value to the
# settings (minkref.toml, or [tool.minkref] of pyproject.toml). Exits as `minkref verify` does.
set -uo pipefail

report=${REPORT:-minkref-report}
IFS=$' \t\r\n' read -d '' -r -a words <<<"${TARGETS:-}"
if [[ ${#words[@]} == 0 && ! -f minkref.toml ]] && ! grep -qs '^\[tool\.minkref\]' pyproject.toml; then
  echo "name the targets, separated by spaces, or write settings: minkref.toml" >&2
  exit 2
fi
IFS=$' \t\r\n' read -d '' -r -a further <<<"${ARGUMENTS:-}"
[[ -z ${SECONDS_GIVEN:-} ]] || words+=(--seconds "$SECONDS_GIVEN")
[[ -z ${SEED:-} ]] || words+=(--seed "$SEED")
[[ -z ${BASELINE:-} ]] || words+=(--baseline "$BASELINE")
mkdir -p "$report"
words+=(--report "$report" --junit "$report/junit.xml" --sarif "$report/results.sarif")
words+=(--markdown "$report/summary.md" --lines "$report/findings.jsonl")
minkref verify "${words[@]}" ${further[@]+"${further[@]}"}
code=$?
if [[ -n ${GITHUB_STEP_SUMMARY:-} && -f $report/summary.md ]]; then
  cat "$report/summary.md" >>"$GITHUB_STEP_SUMMARY"
fi
exit "$code"

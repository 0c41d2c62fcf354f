#!/bin/bash
# verify_in_ci.sh: the step of action.yml. Reads TARGETS, SECONDS_GIVEN, SEED, BASELINE, ARGUMENTS and REPORT; writes the
# report, JUnit XML and SARIF to the folder REPORT, and the summary to GITHUB_STEP_SUMMARY where that is set.
# TARGETS and ARGUMENTS are split at spaces. Exits as `minkref verify` does.
set -uo pipefail

report=${REPORT:-minkref-report}
read -r -a targets <<<"${TARGETS:?name the targets, separated by spaces}"
read -r -a further <<<"${ARGUMENTS:-}"
words=("${targets[@]}" --seconds "${SECONDS_GIVEN:-120}" --seed "${SEED:-1}")
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

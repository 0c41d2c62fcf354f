#!/bin/bash
# allow_user_namespaces.sh: lets bubblewrap make user namespaces on a machine that is thrown away after the job. Ubuntu 24.04
# keeps them from programs without a profile of AppArmor (kernel.apparmor_restrict_unprivileged_userns); other systems have no
# such setting, and nothing is done. Needs root, or sudo that asks for nothing.
set -euo pipefail
setting=${1:-/proc/sys/kernel/apparmor_restrict_unprivileged_userns}
[[ -e $setting && $(<"$setting") != 0 ]] || exit 0
if [[ -w $setting ]]; then
  echo 0 >"$setting"
else
  echo 0 | sudo --non-interactive tee "$setting" >/dev/null
fi

#!/usr/bin/env bash
# The core needs Eigen alone: no symbol of other libraries in it. The second library is a control: it does use one.
# Usage: core_symbols.sh NM CORE_LIBRARY LIBRARY_WITH_FMT
set -euo pipefail
foreign='(fcl|fmt|nlohmann|boost|CLI)::'
found() { "$1" -C "$2" 2>/dev/null | grep -E "\b$foreign" || true; }

[ -n "$(found "$1" "$3")" ] || { echo "$3 shows no foreign symbol: this test sees nothing"; exit 1; }
in_core=$(found "$1" "$2")
[ -z "$in_core" ] || { echo "$2 has foreign symbols:"; head -n 10 <<<"$in_core"; exit 1; }
"$1" -C "$2" 2>/dev/null | grep ' T carom::simulate(' >/dev/null || { echo "$2 has no carom::simulate: is it the core?"; exit 1; }

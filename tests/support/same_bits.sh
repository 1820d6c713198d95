#!/usr/bin/env bash
# The event log of every scene must be the same, bit for bit, from two compilers and two optimisation levels.
# Usage: same_bits.sh PROGRAM OTHER_PROGRAM SCENE_DIR
set -euo pipefail
[ -x "$2" ] || { echo "$2 is not built (tools/build clang carom_hashes)"; exit 1; }
# Piles that settle solve thousands of systems of equations: nothing for a build without optimisation.
mapfile -t scenes < <(find "$3" -name '*.json' ! -name '*.schema.json' ! -name 'settle_*' | sort)
[ ${#scenes[@]} -gt 0 ] || { echo "no scenes in $3"; exit 1; }
one=$("$1" "${scenes[@]}")
other=$("$2" "${scenes[@]}")
if [ "$one" != "$other" ]; then
    diff <(echo "$one") <(echo "$other")
    exit 1
fi
echo "$one"

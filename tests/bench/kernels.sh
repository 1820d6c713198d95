#!/usr/bin/env bash
# What each kernel leaves out, in instructions (callgrind, x86-64-v3): a table of special against general kernel.
# Usage: tests/bench/kernels.sh (builds the bench preset; needs valgrind). The event hashes of each pair must be equal.
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v valgrind >/dev/null || { echo "kernels.sh: needs valgrind (apt-get install valgrind)" >&2; exit 1; }
tools/build bench carom_kernels
log=$(mktemp)
trap 'rm -f "$log"' EXIT

count() { # CASE KERNEL -> "instructions impacts hash", the start and the reading of the scene included
    local answer
    answer=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null build/bench/carom_kernels "$1" "$2" 2>"$log") || { cat "$log" >&2; return 1; }
    echo "$(sed -n 's/.*Collected : //p' "$log") $answer"
}
printf '%-24s %-10s %-10s %14s %14s %9s %7s\n' case kernel against instructions against impacts ratio
row() { # CASE KERNEL BASE_CASE BASE_KERNEL LABEL [different]
    local a b
    a=$(count "$1" "$2") && b=$(count "$3" "$4") || exit 1
    read -ra a <<<"$a"
    read -ra b <<<"$b"
    [ "${6:-}" = different ] || [ "${a[2]}" = "${b[2]}" ] || { echo "kernels.sh: $1: $2 and $5 give different hashes" >&2; exit 1; }
    printf '%-24s %-10s %-10s %14d %14d %9d %7.3f\n' "$1" "$2" "$5" "${a[0]}" "${b[0]}" "${a[1]}" \
        "$(awk "BEGIN { print ${a[0]} / ${b[0]} }")"
}
row one_ball single one_ball general general
row one_ball single by_hand - by_hand
row one_ball single plain_by_hand - plain different
row gas_1000 uniform gas_1000 general general
row gas_with_gravity general gas_with_gravity general itself
row gas_with_fixed_spheres general gas_with_gravity general without different

#!/usr/bin/env bash
# What an impact in a gas costs, in instructions (callgrind, x86-64-v3): the difference of two lengths of a run, after
# 20 impacts a sphere. Usage: tests/bench/gas.sh [N...] (1000; builds the bench preset; needs valgrind).
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v valgrind >/dev/null || { echo "gas.sh: needs valgrind (apt-get install valgrind)" >&2; exit 1; }
tools/build bench carom_gas
count() { # N PHI IMPACTS SEARCH -> instructions
    valgrind --tool=callgrind --callgrind-out-file=/dev/null build/bench/carom_gas "$@" 2>&1 >/dev/null | sed -n 's/.*Collected : //p'
}
printf '%8s %5s %-16s %12s\n' N phi search instructions
for n in "${@:-1000}"; do
    for phi in 0.1 0.3 0.5; do
        for search in neighbour_lists cell_grid; do
            short=$(count "$n" $phi $((20 * n)) $search)
            long=$(count "$n" $phi $((24 * n)) $search)
            printf '%8d %5s %-16s %12d\n' "$n" $phi $search $(((long - short) / (4 * n)))
        done
        build/bench/carom_gas "$n" $phi $((24 * n)) neighbour_lists
    done
done

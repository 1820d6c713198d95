#!/usr/bin/env bash
# FCL and libccd are in the command line tool where they were found, and in no case in the core.
# Usage: peer_symbols.sh NM CORE_LIBRARY TOOL [PEER ...], a peer being fcl or ccd.
set -euo pipefail
nm=$1 core=$2 tool=$3
shift 3
used='(\bfcl::|\bU ccd[A-Z])'

for peer in fcl ccd; do
    linked=no wanted=no
    ldd "$tool" | grep "lib$peer\.so" >/dev/null && linked=yes
    for each in "$@"; do [ "$each" != "$peer" ] || wanted=yes; done
    # libfcl brings libccd along, whether the tool uses it or not.
    if [ "$linked" != "$wanted" ] && ! { [ $peer = ccd ] && [ $linked = yes ]; }; then
        echo "$tool: lib$peer linked: $linked, found when it was configured: $wanted"
        exit 1
    fi
done
if [ $# -gt 0 ] && ! "$nm" -DC "$tool" | grep -E "$used" >/dev/null; then
    echo "$tool shows no symbol of $*: this test sees nothing"
    exit 1
fi
in_core=$("$nm" -C "$core" 2>/dev/null | grep -E "$used" || true)
[ -z "$in_core" ] || { echo "$core has foreign symbols:"; head -n 10 <<<"$in_core"; exit 1; }

#!/usr/bin/env bash
# Installs a build into a temporary folder and builds a project of somebody else against it, with the README's programs
# and scenes in it; then runs them all.
# Usage: check.sh CMAKE BUILD_DIR SOURCE_DIR CONFIG GENERATOR COMPILER FLAGS
set -euo pipefail
cmake=$1 build=$2 source=$3 config=$4 generator=$5 compiler=$6 flags=$7
ctest=$(dirname "$cmake")/ctest
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }; }

quietly "$cmake" --install "$build" --prefix "$work/prefix" --config "$config" --component development

# Block k of a language, in the README's order, becomes readme_k.EXTENSION.
blocks() {
    awk -v start="^\`\`\`$1\$" -v name="$work/readme_" -v extension="$1" '
        $0 ~ start { inside = 1; k += 1; file = name k "." extension; next }
        /^```$/ { inside = 0 }
        inside { print > file }' "$source/README.md"
    ls "$work"/readme_*."$1" | paste -sd ';'
}
programs=$(blocks cpp)
scenes=$(blocks json)

# Unoptimised: what is tested is whether it builds.
quietly "$cmake" -S "$source/tests/install" -B "$work/consumer" -G "$generator" -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_PREFIX_PATH="$work/prefix" \
    -DREADME_PROGRAMS="$programs" -DREADME_SCENES="$scenes"
quietly "$cmake" --build "$work/consumer"
"$ctest" --test-dir "$work/consumer" --output-on-failure --no-tests=error

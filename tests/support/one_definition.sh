#!/usr/bin/env bash
# No two files define different types of one full name: the linker would take one of them for both, in silence.
# Names at the left margin only, which is where this project has them. Usage: one_definition.sh DIR...
set -euo pipefail

# Of these files, the names that two of them define.
twice() {
    awk '
        FNR == 1 { outer = inner = "" }
        /^namespace [a-z_:]+ \{/ { outer = $2 }
        /^namespace \{/ { inner = FILENAME }        # anonymous: of this file alone
        /^\}  \/\/ namespace$/ { inner = "" }
        /^(class|struct|enum class) [A-Z]/ && !/;/ {
            name = $1 == "enum" ? $3 : $2
            if (name ~ /::/) next
            sub(/[^A-Za-z0-9].*/, "", name)
            full = outer "::" name
            if (inner == "" && full in seen && seen[full] != FILENAME) print full ": " seen[full] " and " FILENAME
            if (inner == "") seen[full] = FILENAME
        }' "$@"
}

mapfile -t files < <(find "$@" -name '*.hpp' -o -name '*.cpp')
found=$(twice "${files[@]}")
[ -z "$found" ] || { echo "$found"; exit 1; }

# The control: a copy defines everything again.
mapfile -t headers < <(grep -lE '^(class|struct) [A-Z]' "${files[@]}" | grep '\.hpp$')
header=${headers[0]}
copy=$(mktemp)
trap 'rm -f "$copy"' EXIT
cp "$header" "$copy"
[ -n "$(twice "$header" "$copy")" ] || { echo "the check itself finds nothing"; exit 1; }

#!/usr/bin/env bash
# The Python of docs/recording.md reads a recording: it must find the events that the tool counts.
# Usage: recording_python.sh CAROM DOCUMENT
set -euo pipefail
carom=$1 document=$2
python3 -c 'import sqlite3, zlib' 2>/dev/null || { echo "no python3 with sqlite3 and zlib: skipped"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
awk '/^```python$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$document" >"$work/read.py"
"$carom" run bouncing_ball -q --events "$work/events.csv" -o "$work/run" >/dev/null
python3 "$work/read.py" "$work/run/run.carom" >"$work/read"
[ "$(wc -l <"$work/read")" -eq "$(($(wc -l <"$work/events.csv") - 1))" ] || { echo "not all events were read"; exit 1; }
# The last number of a line is jz, in both.
python3 - "$work/read" "$work/events.csv" <<'CHECK'
import ast, csv, sys
rows = list(csv.DictReader(open(sys.argv[2])))
for line, row in zip(open(sys.argv[1]), rows):
    impulse = ast.literal_eval(line.split(" ", 3)[3])
    assert impulse == [float(row[k]) for k in ("jx", "jy", "jz")], (line, row)
CHECK

#!/usr/bin/env bash
# The JSON schema and the loader must accept and refuse the same files. Usage: agree.sh CAROM SCENE_DIR WEB_DIR
# Skipped (exit 77) without node or ajv.
set -euo pipefail
node=$(command -v node || command -v nodejs) || { echo "skipped: no node"; exit 77; }
exec "$node" "$(dirname "$0")/agree.mjs" "$@"

#!/usr/bin/env bash
# Every public header compiles on its own, with Eigen and nothing else. Usage: headers_alone.sh COMPILER INCLUDE_DIR EIGEN_DIR
set -euo pipefail
headers=("$2"/carom/*.hpp)
[ -f "${headers[0]}" ] || { echo "no headers in $2/carom"; exit 1; }
failed=0
for header in "${headers[@]}"; do
    "$1" -std=c++20 -fsyntax-only -Wall -Wextra -I"$2" -isystem "$3" -DEIGEN_DONT_VECTORIZE -DEIGEN_MAX_ALIGN_BYTES=16 \
        -x c++ - <<<"#include <carom/$(basename "$header")>" || { echo "$header does not compile alone"; failed=1; }
done
echo "${#headers[@]} headers"
exit "$failed"

#!/usr/bin/env bash
#############################################################################
#
# Circular fiducial markers for ViSP, the Visual Servoing Platform.
#
# This software is free software; you can redistribute it and/or modify
# it under the terms of the GNU General Public License as published by
# the Free Software Foundation; either version 2 of the License, or
# (at your option) any later version.
# See the file LICENSE at the root directory of this source
# distribution for additional information about the GNU GPL.
#
# This file is provided AS IS with NO WARRANTY OF ANY KIND, INCLUDING THE
# WARRANTY OF DESIGN, MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE.
#
# Description:
# Installs what is missing, builds, and runs all tests.
#
#############################################################################

# bash test/run.sh [--build DIR] [-D<cmake option>...]     DIR: build folder, build/ in the project unless told
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
options=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --build)
      [[ $# -ge 2 ]] || { echo "run.sh: --build needs a folder" >&2; exit 2; }
      build=$2; shift 2 ;;
    -D?*) options+=("$1"); shift ;;
    -h | --help) echo "usage: bash test/run.sh [--build DIR] [-D<cmake option>...]"; exit 0 ;;
    *) echo "run.sh: unknown argument $1; see --help" >&2; exit 2 ;;
  esac
done

bash "$root/cmake/install-packages.sh" build test
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTS=ON -DBUILD_TUTORIALS=ON -DBUILD_EXAMPLES=ON \
      ${options[@]+"${options[@]}"}
cmake --build "$build" -j"$(nproc)"

# CTest's verdict is said once more, as the last line.
log=$build/ctest-output.txt
status=0
ctest --test-dir "$build" --output-on-failure --no-tests=error -j"$(nproc)" 2>&1 | tee "$log" || status=$?
grep -E '^[0-9]+% tests passed' "$log" | tail -n 1 || true
exit "$status"

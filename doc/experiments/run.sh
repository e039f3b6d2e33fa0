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
# Does all experiments and puts the report and its figures beside this script.
#
#############################################################################

# bash doc/experiments/run.sh [--build DIR] [--data DIR] [<option of circle-marker-experiments>...]
#   --build DIR: build folder, build/ in the project unless told
#   --data DIR: where the data (CSV) is kept, <build>/experiments unless told; frames that are there are not made again
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build
data=
options=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --build | --data)
      [[ $# -ge 2 ]] || { echo "run.sh: $1 needs a folder" >&2; exit 2; }
      if [[ $1 == --build ]]; then build=$2; else data=$2; fi
      shift 2 ;;
    -h | --help)
      echo "usage: bash doc/experiments/run.sh [--build DIR] [--data DIR] [<option of circle-marker-experiments>...]"
      exit 0 ;;
    *) options+=("$1"); shift ;;
  esac
done
data=${data:-$build/experiments}

program=$build/bin/circle-marker-experiments
[[ -x $program ]] || { echo "run.sh: there is no $program; build the project first, see README.md" >&2; exit 1; }

start=$SECONDS
# Experiment 1 needs a camera; the simulated bus, which is part of the tests, stands in for it.
recording=()
if [[ -n $(find "$build" -name libcircle_marker_simulated_dc1394.so -print -quit) ]]; then
  bash "$here/experiment-1.sh" --build "$build" --output "$data/experiment-1" --simulated --no-images > /dev/null
  recording=(--recording "$data/experiment-1/recording")
else
  echo "run.sh: experiment 1 is left out: its simulated camera is part of the tests, build with -DBUILD_TESTS=ON" >&2
fi
"$program" --output "$data" --experiment all ${recording[@]+"${recording[@]}"} ${options[@]+"${options[@]}"} > /dev/null
rm -f "$here"/*.svg
cp "$data"/report.md "$data"/*.svg "$here/"
echo "Done in $((SECONDS - start)) s: $here/report.md"

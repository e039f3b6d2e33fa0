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
# From a fresh checkout to pictures: installs, builds, prints a marker, servos, compares with AprilTag.
#
#############################################################################

# bash tutorial/demo.sh [--output DIR] [--build DIR]     out/ and build/ in the project unless told
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
output=$root/out
while [[ $# -gt 0 ]]; do
  case $1 in
    --build | --output)
      [[ $# -ge 2 ]] || { echo "demo.sh: $1 needs a folder" >&2; exit 2; }
      if [[ $1 == --build ]]; then build=$2; else output=$2; fi
      shift 2 ;;
    -h | --help) echo "usage: bash tutorial/demo.sh [--output DIR] [--build DIR]"; exit 0 ;;
    *) echo "demo.sh: unknown argument $1; see --help" >&2; exit 2 ;;
  esac
done

# say <what is done now>
say()
{
  printf '\n== %s\n' "$1"
}

say "Packages, and the programs (some minutes the first time)"
bash "$root/cmake/install-packages.sh" build
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBUILD_TUTORIALS=ON -DBUILD_EXAMPLES=ON
cmake --build "$build" --target circle_marker_programs -j"$(nproc)"

# Files of an earlier run would pass for this one's.
mkdir -p "$output"
rm -rf "$output/marker.pdf" "$output/marker.svg" "$output/servo-circle" "$output/servo-both" "$output/compare"
mkdir -p "$output/servo-circle" "$output/servo-both" "$output/compare"

say "A marker to print: golay23, id 5, 180 mm, on A4"
"$build/bin/circle-marker-create" --family golay23 --id 5 --size 0.180 --sheet a4 --output "$output/marker.pdf"
"$build/bin/circle-marker-create" --family golay23 --id 5 --size 0.180 --sheet none --output "$output/marker.svg"

say "Visual servo on the simulated camera: circle"
"$build/bin/tutorial-circle-marker-pbvs" --detector circle --display-off --output "$output/servo-circle"

say "Visual servo on the simulated camera: circle and AprilTag on one object, each covered for a part of the way"
"$build/bin/tutorial-circle-marker-pbvs" --detector both --display-off --output "$output/servo-both"

say "Circle against AprilTag: same footprint, same poses, same camera and noise"
"$build/bin/circle-marker-compare-apriltag" --frames 100 --output "$output/compare"

# list <title> <file name pattern>...: the files of these kinds that were written
list()
{
  local title=$1 pattern
  local kinds=()
  shift
  for pattern in "$@"; do
    kinds+=(${kinds[@]+-o} -name "$pattern")
  done
  say "$title"
  find "$output" -type f \( "${kinds[@]}" \) | sort
}
list "Sheets to print" '*.pdf'
list "Pictures and curves" '*.svg' '*.png' '*.jpg' '*.ppm' '*.pgm'
list "Tables" '*.csv' '*.json'

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
# The thesis's experiment 1: records a marker at several places, and evaluates.
#
#############################################################################

# See usage() below, and experiment-1.md for how to set up camera and marker.
set -euo pipefail

usage()
{
  cat <<'END'
usage: bash doc/experiments/experiment-1.sh --output DIR [options] [<option of tutorial-circle-marker-detector-live>...]
  --output DIR     recording (DIR/recording/<place>/) and report (DIR/report.md, .html); places that are recorded are
                   not recorded again: remove a place's folder to repeat it
  --places "LIST"  places, metres from the camera, or slide; "1 2 3 4 5 slide" unless told
  --frames N       images of each place, 600 unless told (40 s at 15 images a second)
  --no-images      keep the poses only: images cannot be evaluated again with another detector
  --simulated      the Chameleon of the thesis on a simulated FireWire bus in place of a camera
  --build DIR      build folder, build/ in the project unless told
Options for the live detector: --source, --intrinsic, --camera-name, --size, --family, --video-mode and others; see
build/bin/tutorial-circle-marker-detector-live --help. Unless told: firewire:0, 1280x960_mono8 at 15 images a second,
data/chameleon.xml, a marker of 0.180 m.
END
}

complain()
{
  echo "experiment-1.sh: $1" >&2
  exit "$2"
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$root/build
output=
places="1 2 3 4 5 slide"
frames=600
keeps_images=yes
simulated=
family=golay23
size=0.180
options=()
has() # Whether an option was given to the live detector.
{
  local option
  for option in ${options[@]+"${options[@]}"}; do
    [[ $option == "$1" ]] && return 0
  done
  return 1
}
while [[ $# -gt 0 ]]; do
  case $1 in
    --output | --places | --frames | --build | --family | --size)
      [[ $# -ge 2 ]] || complain "$1 needs a value; see --help" 2
      case $1 in
        --output) output=$2 ;;
        --places) places=$2 ;;
        --frames) frames=$2 ;;
        --build) build=$2 ;;
        --family) family=$2 ;;
        --size) size=$2 ;;
      esac
      shift 2 ;;
    --no-images) keeps_images=; shift ;;
    --simulated) simulated=yes; shift ;;
    -h | --help) usage; exit 0 ;;
    *) options+=("$1"); shift ;;
  esac
done
[[ -n $output ]] || complain "name a folder with --output; see --help" 2
live=$build/bin/tutorial-circle-marker-detector-live
experiments=$build/bin/circle-marker-experiments
for program in "$live" "$experiments"; do
  [[ -x $program ]] || complain "there is no $program; build the project first, see README.md" 1
done
options+=(--family "$family" --size "$size" --display-off --all-images --count "$frames")
has --intrinsic || options+=(--intrinsic "$root/data/chameleon.xml" --camera-name Chameleon)
has --source || options+=(--source firewire:0 --video-mode 1280x960_mono8 --framerate 15)

# What the simulated camera sees: the marker on the optical axis, tilted by two degrees as by hand.
bus_of() # place
{
  awk -v place="$1" -v frames="$frames" -v family="$family" -v size="$size" 'BEGIN {
    printf "{\"cameras\": [{\"guid\": 49712223529864935, \"vendor\": \"Point Grey Research\", \"model\": \"Chameleon\"}],"
    printf "\"usb\": true, \"focal_length\": 1630.72, \"family\": \"%s\", \"id\": %d, \"size\": %s, \"poses\": [",
           family, family == "ring" || family == "disc" ? -1 : 5, size
    poses = place == "slide" ? frames : 1
    tilt = 2 * atan2(0, -1) / 180
    c = cos(tilt)
    s = sin(tilt)
    for (i = 0; i < poses; ++i) {
      z = place == "slide" ? 1 + 4 * i / (poses - 1) : place
      printf "%s[1, 0, 0, 0, 0, %.9f, %.9f, 0, 0, %.9f, %.9f, %.9f, 0, 0, 0, 1]", i ? ", " : "", c, -s, s, c, z
    }
    print "]}"
  }'
}

run=()
if [[ -n $simulated ]]; then
  library=$(find "$build" -name libcircle_marker_simulated_dc1394.so -print -quit)
  [[ -n $library ]] || complain "the simulated bus is part of the tests: build with -DBUILD_TESTS=ON, with libdc1394" 1
fi
for place in $places; do
  name=$place
  [[ $place == slide* ]] || name=${place}m
  folder=$output/recording/$name
  if [[ -e $folder/poses.jsonl ]]; then
    echo "$name is recorded already" >&2
    continue
  fi
  mkdir -p "$folder"
  if [[ -n $simulated ]]; then
    bus_of "$place" > "$output/recording/$name.bus.json"
    run=(env "LD_PRELOAD=$library" "CIRCLE_MARKER_SIMULATED_BUS=$output/recording/$name.bus.json")
  elif [[ $place == slide* ]]; then
    read -r -p "Put the marker 1 m away; press Enter, then slide it to 5 m within $frames images. "
  else
    read -r -p "Put the marker $place m away, in the image's centre, facing the camera; press Enter. "
  fi
  echo "recording $frames images: $name" >&2
  if [[ -n $keeps_images ]]; then
    ${run[@]+"${run[@]}"} "$live" "${options[@]}" --record "$folder/img%04d.png"
  else
    ${run[@]+"${run[@]}"} "$live" "${options[@]}" --json "$folder/poses.jsonl"
  fi
done
"$experiments" --output "$output" --experiment 1 --recording "$output/recording"

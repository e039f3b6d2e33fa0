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
# Runs a program in an X server without a screen, clicks into its window, and keeps what the screen showed.
#
#############################################################################

# click_in_window.sh <folder of the server's picture> <title> <seconds between clicks> <button>...
#                    -- <program> <argument>...
# Before each click the screen is copied to screen-0.xwd, screen-1.xwd and so on. Ends as the program does.
set -u
picture=$1/Xvfb_screen0
title=$2
pause=$3
shift 3
buttons=()
while [[ $1 != -- ]]; do
  buttons+=("$1")
  shift
done
shift

timeout 60 "$@" &
program=$!
window=$(timeout 30 xdotool search --sync --onlyvisible --name "$title" | head -n 1)
if [[ -z $window ]]; then
  echo "click_in_window.sh: no window \"$title\" appeared in 30 s" >&2
  kill "$program" 2>/dev/null
  exit 99
fi
for i in "${!buttons[@]}"; do
  sleep "$pause"
  cp "$picture" "screen-$i.xwd"
  xdotool mousemove --window "$window" 60 60 click "${buttons[i]}"
done
wait "$program"

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
# Runs a program in an X server without a screen, presses keys and buttons in its window, keeps what was seen.
#

# act_in_window.sh <folder of the server's picture> <title> <action>... -- <program> <argument>...
# Actions: wait:SECONDS, key:NAME, click:BUTTON, shot:NAME (copies the screen to NAME.xwd), need:FILE (waits until the file
# is there, 20 s at most), drag:BUTTON,U,V (by so many pixels). Keys and buttons are those of the X server, as from a keyboard and a mouse; without a window
# manager the keys go to the window under the pointer. Ends as the program does.
set -u
picture=$1/Xvfb_screen0
title=$2
shift 2
actions=()
while [[ $1 != -- ]]; do
  actions+=("$1")
  shift
done
shift

timeout --kill-after=5 60 "$@" &
program=$!
window=$(timeout 30 xdotool search --sync --onlyvisible --name "$title" | head -n 1)
if [[ -z $window ]]; then
  echo "act_in_window.sh: no window \"$title\" appeared in 30 s" >&2
  kill "$program" 2>/dev/null
  exit 99
fi
xdotool mousemove --window "$window" 60 60
for action in "${actions[@]}"; do
  value=${action#*:}
  case $action in
    wait:*) sleep "$value" ;;
    key:*) xdotool key "$value" ;;
    drag:*) # BUTTON,U,V: from 300, 200 by so many pixels, in steps as a hand makes them
      IFS=, read -r button du dv <<< "$value"
      xdotool mousemove --window "$window" 300 200 mousedown "$button"
      for ((i = 1; i <= 8; i++)); do
        sleep 0.1
        xdotool mousemove --window "$window" $((300 + du * i / 8)) $((200 + dv * i / 8))
      done
      sleep 0.2
      xdotool mouseup "$button" mousemove --window "$window" 60 60 ;;
    click:*) xdotool mousemove --window "$window" 60 60 click "$value" ;;
    shot:*) cp "$picture" "$value.xwd" ;;
    need:*) for ((i = 0; i < 100; i++)); do [[ -e $value ]] && break; sleep 0.2; done ;;
    *) echo "act_in_window.sh: unknown action $action" >&2; kill "$program"; exit 98 ;;
  esac
done
wait "$program"

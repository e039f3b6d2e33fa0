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
# Runs a command with an X server of its own, without a screen.
#
#############################################################################

# in_x_server.sh <folder> <command> <argument>...
# The server keeps its picture in <folder>/Xvfb_screen0. Ends as the command does, whatever becomes of the server, as
# xvfb-run of Debian 12 does not: it ends with 5 if a file of its own cannot be removed. The server itself takes the
# first display that is free, so that several of these run side by side.
set -u
folder=$1
shift

# The server writes the number of its display, and a new line, as soon as programs can connect.
exec {number_of_display}< <(exec Xvfb -displayfd 3 -screen 0 1400x1050x24 -fbdir "$folder" -noreset -nolisten tcp \
                              3>&1 >/dev/null)
server=$!
trap 'kill "$server" 2>/dev/null' EXIT
if ! read -r -t 30 -u "$number_of_display" number; then
  echo "in_x_server.sh: Xvfb did not start (30 s at most); the reason stands above" >&2
  exit 97
fi
DISPLAY=:$number "$@"

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
# Only functions of the sets of instructions' own namespaces may use instructions that not all processors have.
#
#############################################################################

# bash instructions.sh OBJDUMP OBJECT...
# The linker keeps one copy of an inline function. One that was compiled with AVX would then be called on any processor.
set -euo pipefail
objdump=$1; shift
status=0
looked=0
for object in "$@"; do
  case $object in
    */wide_lanes.cpp.o) own='wide_lanes::' ;;
    */widest_lanes.cpp.o) own='widest_lanes::' ;;
    *) continue ;;
  esac
  # Names of functions with an instruction of AVX in their code, on registers of whatever width.
  functions=$("$objdump" --disassemble --demangle --no-show-raw-insn "$object" |
    awk '/^[0-9a-f]+ <.*>:$/ { name = $0 } /^ *[0-9a-f]+:\tv[a-z0-9]+/ { uses[name] = 1 } END { for (name in uses) print name }')
  if [[ -z $functions ]]; then
    echo "$object: no function uses AVX; was it compiled for it?" >&2
    status=1
  elif grep -vF "$own" <<< "$functions" >&2; then
    echo "$object: these functions are not of $own, but use its instructions" >&2
    status=1
  fi
  looked=$((looked + 1))
done
if [[ $looked -ne 2 ]]; then
  echo "instructions.sh: wide_lanes.cpp.o and widest_lanes.cpp.o are not among the objects" >&2
  exit 1
fi
exit $status

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
# Installs the Debian packages that are not there yet.
#
#############################################################################

# bash cmake/install-packages.sh build|test|in-tree|doc ...: the packages of the named uses. Does nothing, and asks for no
# rights, when all are present.
set -euo pipefail

packages=()
for use in "$@"; do
  case $use in
    # The libraries and the programs, and gnuplot, which the programs draw their curves with.
    build) packages+=(build-essential cmake pkg-config libvisp-dev libeigen3-dev libopencv-dev libcairo2-dev
                      libcli11-dev nlohmann-json3-dev gnuplot-nox libbenchmark-dev) ;;
    # GoogleTest; poppler and librsvg read printed sheets back; photographs; a display without a screen; what CPack
    # needs for a Debian package, and help2man for its manual pages.
    test) packages+=(libgtest-dev poppler-utils librsvg2-bin visp-images-data xvfb xdotool dpkg-dev file
                     help2man) ;;
    # To unpack and build ViSP's own source and documentation.
    in-tree) packages+=(dpkg-dev ca-certificates ccache doxygen texlive-binaries texlive-base) ;;
    # The documentation: Doxygen, bibtex for its references and the configuration without which it finds no file, MathJax
    # for its formulas.
    doc) packages+=(doxygen texlive-binaries texlive-base libjs-mathjax) ;;
    *) echo "install-packages.sh: unknown use $use; known: build, test, in-tree, doc" >&2; exit 2 ;;
  esac
done

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "install-packages.sh: this is not Debian. Install what these Debian packages hold, then use cmake and ctest" \
       "as the README says: ${packages[*]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $state == installed ]] || missing+=("$package")
done
if [[ ${#missing[@]} -eq 0 ]]; then
  exit 0
fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "install-packages.sh: run this as root once: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
# A package that asks a question would stop everything.
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"

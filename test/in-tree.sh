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
# Builds, tests and installs the modules inside ViSP's own source tree.
#
#############################################################################

# bash test/in-tree.sh [--visp DIR] [--work DIR] [--quick] [--build-within SECONDS]
#   --visp DIR  ViSP's source; without it, the source of the distribution's package, fetched with apt-get
#   --work DIR  folder for that source, for a copy of this project and for the build, outside of this project; kept, so
#               that the next run is short
#   --quick     of the tutorials and examples only those in quick_programs, of the tests only those in quick_tests
#   --build-within SECONDS  gives up what takes longer to compile, 0 for never (default): a slow machine is no failure
# Ends with 0 (all is well), 1 (it is not), 2 (wrong arguments) or 77 (nothing tested: ViSP's source cannot be had here, or
# the build took too long).
set -euo pipefail
quick_programs=(tutorial-circle-marker-detector tutorial-circle-marker-pbvs circle-marker-create)
# Those that meet ViSP: its projection, its cameras and images, its AprilTag, the public classes, what they read and write;
# and some of private functions, to see that tests can reach those here. The others are the same files for the
# same compiler as standalone.
quick_tests=(testCircleMarkerDatabase testCircleMarkerFamily testDetectorSettings testJsonFile testMarkerPoseBound
             testMarkersAndTruth testMeasure testPoseCircle testPoseCircleErrors testPoseCircleEvidence testPoseCircleState
             testPoseCircleTrackers testProjectionConventions testRecognise testReport testSensor testSimulatedAprilTag)
usage="usage: bash test/in-tree.sh [--visp DIR] [--work DIR] [--quick] [--build-within SECONDS]"
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=${TMPDIR:-/tmp}/circle-marker-in-tree
visp=
quick=false
build_within=0
while [[ $# -gt 0 ]]; do
  case $1 in
    --visp | --work)
      [[ $# -ge 2 ]] || { echo "in-tree.sh: $1 needs a folder" >&2; exit 2; }
      if [[ $1 == --visp ]]; then visp=$2; else work=$2; fi
      shift 2 ;;
    --quick) quick=true; shift ;;
    --build-within)
      [[ ${2:-} =~ ^[0-9]+$ ]] || { echo "in-tree.sh: --build-within needs a number of seconds" >&2; exit 2; }
      build_within=$2; shift 2 ;;
    -h | --help) echo "$usage"; exit 0 ;;
    *) echo "in-tree.sh: unknown argument $1; see --help" >&2; exit 2 ;;
  esac
done
mkdir -p "$work"
work=$(cd "$work" && pwd)
case $work/ in
  "$root"/*) echo "in-tree.sh: $work is inside the project; choose a --work folder outside" >&2; exit 2 ;;
esac
# ViSP looks for modules, and Doxygen for sources, in every folder of the project, in that of a standalone build as well.
# There are copies of our headers in it, so ViSP is given the project without what was built. A file that is as it was at
# the last run keeps the date that it had there, and any other has today's, whatever date it has here (a file that was
# moved, or came from another branch, may be older than the object made of its predecessor): the next run compiles all
# that has changed, and nothing else.
project=$work/project
before=$work/project-before
if [[ -d $project ]]; then
  rm -rf "$before"
  mv "$project" "$before"
fi
mkdir "$project"
(cd "$root" && cp -R CMakeLists.txt README.md LICENSE modules tutorial example test data doc cmake "$project")
(cd "$project" && find . -type f -print0) | while IFS= read -r -d '' file; do
  if cmp -s "$project/$file" "$before/$file"; then
    touch -r "$before/$file" "$project/$file"
  fi
done
rm -rf "$before"

bash "$root/cmake/install-packages.sh" build test
if ! bash "$root/cmake/install-packages.sh" in-tree; then
  echo "in-tree.sh: nothing was tested: what unpacks ViSP's source cannot be installed" >&2
  exit 77
fi

# fetch_visp: prints the folder of ViSP's source from the distribution. Sources are looked up in a private copy of the
# package lists, so that nothing of the system's own set-up changes.
fetch_visp()
{
  local apt=$work/apt file
  if ! compgen -G "$work/source/visp-*/CMakeLists.txt" >/dev/null; then
    mkdir -p "$apt/sources" "$apt/lists/partial" "$apt/cache/archives/partial" "$work/source"
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
      [[ -f $file ]] || continue
      sed -n 's/^deb /deb-src /p' "$file" > "$apt/sources/$(basename "$file" .list).list"
    done
    for file in /etc/apt/sources.list.d/*.sources; do
      [[ -f $file ]] || continue
      sed 's/^Types:.*/Types: deb-src/' "$file" > "$apt/sources/$(basename "$file")"
    done
    local options=(-q -o "Dir::State::Lists=$apt/lists" -o "Dir::Cache=$apt/cache" -o Dir::Etc::SourceList=/dev/null
                   -o "Dir::Etc::SourceParts=$apt/sources" -o APT::Sandbox::User=)
    # A repository without sources is no reason to stop; without ViSP's source the next command fails.
    apt-get "${options[@]}" update >&2 || true
    (cd "$work/source" && apt-get "${options[@]}" source visp >&2)
  fi
  compgen -G "$work/source/visp-*" | while read -r file; do
    if [[ -f $file/CMakeLists.txt ]]; then echo "$file"; fi
  done | tail -n 1
}

if [[ -z $visp ]]; then
  visp=$(fetch_visp) || visp=
  if [[ -z $visp ]]; then
    echo "in-tree.sh: nothing was tested: the distribution's source of ViSP cannot be had here (no network, or no" \
         "sources in its archive); see above, or name a source with --visp" >&2
    exit 77
  fi
fi
[[ -f $visp/modules/core/CMakeLists.txt ]] || { echo "in-tree.sh: no source of ViSP in '$visp'" >&2; exit 1; }
visp=$(cd "$visp" && pwd)
build=$work/build-$(basename "$visp")
echo "ViSP's source: $visp; copy of the project: $project; build: $build"

# Without USE_CXX_STANDARD, ViSP 3.5.0 changes the standard at the second configuration and compiles all again.
options=(-DCMAKE_BUILD_TYPE=Release -DUSE_CXX_STANDARD=17 "-DVISP_CONTRIB_MODULES_PATH=$project"
         -DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
         -DUSE_MATHJAX=ON -DBUILD_APPS=OFF -DBUILD_DEMOS=OFF -DBUILD_JAVA=OFF -DBUILD_TESTS=ON -DBUILD_TUTORIALS=ON -DBUILD_EXAMPLES=ON)
for module in ar dnn_tracker imgproc java java_bindings_generator klt mbt python python_bindings rbt tt tt_mi; do
  options+=("-DBUILD_MODULE_visp_$module=OFF")
done

# configure <log>
configure()
{
  if ! cmake -S "$visp" -B "$build" "${options[@]}" > "$1" 2>&1; then
    tail -n 40 "$1" >&2
    echo "in-tree.sh: ViSP could not be configured; all of it is in $1" >&2
    exit 1
  fi
}
# has_target <name>
has_target()
{
  grep -q "^\.\.\. $1\$" "$work/targets.txt"
}

configure "$work/configure-1.log"
# Again, as every later build does: 3.7 and later lose the tutorials of a contrib module here.
configure "$work/configure-2.log"
cmake --build "$build" --target help > "$work/targets.txt"

mapfile -t tests < <(find "$root"/modules/*/test -name '*.cpp' -exec basename {} .cpp \; | sort)
# A program is one file or a folder of files; common/ is what programs share.
mapfile -t programs < <(cd "$root" && find tutorial/circle_marker example/circle_marker -name '*.cpp' |
                        cut -d/ -f3 | sed 's/\.cpp$//' | grep -vx common | sort -u)
if $quick; then
  programs=("${quick_programs[@]}")
  tests=("${quick_tests[@]}")
fi
servo=tutorial-circle-marker-pbvs
for target in visp_circle_marker visp_circle_marker_simulator $servo "${tests[@]}" "${programs[@]}"; do
  has_target "$target" || { echo "in-tree.sh: ViSP's build does not know the target $target" >&2; exit 1; }
done

status=0
timeout --kill-after=30 "$build_within" cmake --build "$build" -j"$(nproc)" --target \
        visp_circle_marker visp_circle_marker_simulator "${tests[@]}" "${programs[@]}" || status=$?
case $status in
  0) ;;
  124 | 137)
    echo "in-tree.sh: nothing was tested: the build was not done after $build_within seconds" >&2
    exit 77 ;;
  *) exit 1 ;;
esac

# ViSP's versions put the programs of a tutorial into different folders.
"$(find "$build" -name $servo -type f -perm -u+x | head -n 1)" --detector both --display-off --output "$work/servo"

pattern=$(IFS='|'; echo "${tests[*]}")
# install_and_use: ViSP with our modules in a temporary prefix, and a third party's project on it, as test/run.sh has it
# for the standalone installation. Installing takes ViSP's manual pages and scripts as well. ViSP's libraries are installed
# without the place of each other: a prefix that the system does not search has to be named.
install_and_use()
{
  local prefix=$work/prefix consumer=$work/install-consumer
  rm -rf "$prefix" "$consumer"
  cmake --build "$build" -j"$(nproc)" --target visp_modules man developer_scripts > "$work/install.log" 2>&1 &&
    cmake --install "$build" --prefix "$prefix" >> "$work/install.log" 2>&1 ||
    { tail -n 40 "$work/install.log" >&2; return 1; }
  cmake -S "$root/test/install-consumer" -B "$consumer" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=$prefix" &&
    grep -q "^VISP_DIR:PATH=$prefix/" "$consumer/CMakeCache.txt" &&
    cmake --build "$consumer" &&
    LD_LIBRARY_PATH=$(dirname "$(find "$prefix" -name libvisp_circle_marker.so | head -n 1)") "$consumer/install-consumer"
}
install_and_use || { echo "in-tree.sh: the modules cannot be used from an installed ViSP" >&2; exit 1; }

# document: the pages, tutorials and examples of our modules in ViSP's own documentation. Doxygen reads all of ViSP; only
# what it says of our files counts.
document()
{
  local html=$build/doc/html page missing=0
  if ! has_target visp_doc; then
    echo "ViSP's documentation was not made: there is no Doxygen (bash cmake/install-packages.sh in-tree)"
    return 0
  fi
  rm -rf "$html" "$work/doc"
  mkdir -p "$work/doc"
  find "$build" -maxdepth 2 -name warning.log -delete
  if ! cmake --build "$build" --target visp_doc > "$work/doc/visp_doc.log" 2>&1; then
    tail -n 40 "$work/doc/visp_doc.log" >&2
    return 1
  fi
  find "$build" -maxdepth 2 -name warning.log -exec cat {} + > "$work/doc/warnings"
  if grep -F "$project/" "$work/doc/warnings" >&2; then
    return 1
  fi
  while read -r page; do
    if [[ ! -s $html/$page.html ]]; then
      echo "no page $page" >&2
      missing=1
    fi
  done < <(sed -n 's/^ *\\page \([^ ]*\) .*/\1/p' "$root"/modules/*/doc/*.dox
           sed -n 's/^ *\\defgroup \([^ ]*\) .*/group_\1/p' "$root"/modules/*/doc/*.dox | sed 's/_/__/g'
           find "$root/tutorial" "$root/example" -name '*.cpp' -exec sed -n 's/^ *\\example //p' {} + |
             sed 's/\//_2/g;s/\./_8/g;s/$/-example/')
  return "$missing"
}
document || { echo "in-tree.sh: ViSP's documentation has not all of the modules'" >&2; exit 1; }

log=$work/ctest-output.txt
status=0
ctest --test-dir "$build" --output-on-failure --no-tests=error -j"$(nproc)" -R "^($pattern)\$" 2>&1 | tee "$log" ||
  status=$?
grep -E '^[0-9]+% tests passed' "$log" | tail -n 1 || true
exit "$status"

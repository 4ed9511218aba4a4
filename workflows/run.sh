#!/bin/sh
# From a bare Debian 12 machine to the report of the quick chain: installs what is missing, builds, runs.
#   sh workflows/run.sh [further options of `mesobridge workflow lj-to-sdpd`]
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
. "$root/workflows/install.sh"
. "$root/workflows/build.sh"

install_packages
# The other settings stay as they were, so that a checkout whose tests are built is not compiled again.
configure_project "$root" "$root/build" -DCMAKE_BUILD_TYPE=Release
build_target mesobridge

report=$root/out/lj-to-sdpd/report.html
"$root/build/mesobridge" workflow lj-to-sdpd --preset quick -o "$root/out/lj-to-sdpd" "$@" >"$root/build/run.log"
echo "The report is ready: $report"

#!/bin/sh
# Installs what is missing, builds with warnings as errors and runs all tests but the long studies.
#   sh tests/run.sh [options for ctest, e.g. -R Store]
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
. "$root/workflows/install.sh"
. "$root/workflows/build.sh"

# Programs of others that read what ours writes or write what it reads, and a screen for the one that draws.
mesobridge_packages="$mesobridge_packages lammps python3-h5py python3-ase python3-mdanalysis paraview python3-paraview xvfb zstd"
install_packages
configure_project "$root" "$root/build" -DCMAKE_BUILD_TYPE=Release -DMESOBRIDGE_TESTS=ON -DMESOBRIDGE_WERROR=ON
build_target all

echo "Testing ..." >&2
log=$root/build/test.log
status=0
ctest --test-dir "$root/build" -LE long -j "${MESOBRIDGE_JOBS:-2}" --output-on-failure --no-tests=error "$@" \
  >"$log" 2>&1 || status=$?

# ctest closes with "98% tests passed, 2 tests failed out of 100" and, if so, the names of those which failed.
summary=$(sed -n 's/^.*% tests passed, \([0-9]*\) tests failed out of \([0-9]*\).*$/\1 \2/p' "$log")
failed=${summary% *}
total=${summary#* }
if [ "$status" -ne 0 ]; then
  sed -n '/^Start\|^ *[0-9]*\/[0-9]* Test.*Passed/!p' "$log" >&2
fi
if [ -z "$summary" ]; then
  echo "The tests could not be run: see $log"
  exit 1
fi
echo "$((total - failed)) passed, $failed failed"
exit "$status"

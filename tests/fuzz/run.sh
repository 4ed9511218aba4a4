#!/bin/sh
# Builds the program with the address and undefined-behaviour sanitizers and gives it strange inputs.
#   sh tests/fuzz/run.sh [options of the fuzzer, e.g. --count 1000 --seed 2 --keep FOLDER]
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
. "$root/workflows/install.sh"
. "$root/workflows/build.sh"

install_packages
build=$root/build-sanitize
configure_project "$root" "$build" -DCMAKE_BUILD_TYPE=Sanitize -DMESOBRIDGE_TESTS=ON
build_target fuzz

# Memory that is never given back is no fault of a program that ends; more than 4 GB at once, for inputs of some kB, is.
export ASAN_OPTIONS="detect_leaks=0:max_allocation_size_mb=4096:allocator_may_return_null=0:${ASAN_OPTIONS:-}"
export UBSAN_OPTIONS="print_stacktrace=1:${UBSAN_OPTIONS:-}"
echo "Fuzzing ..." >&2
"$build/fuzz" "$@"

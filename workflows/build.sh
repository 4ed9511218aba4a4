# Sourced, not run: configures and builds quietly; the log is shown only when something fails.
#   configure_project SOURCE BUILD_DIRECTORY [CMake options ...], then   build_target TARGET

quietly() {
  what=$1
  log=$2
  shift 2
  "$@" >>"$log" 2>&1 && return 0
  echo "$what failed; the end of $log:" >&2
  # With Ninja the first failure says more than the last lines.
  { grep -n -m 1 -A 15 -E '^FAILED|CMake Error' "$log" || true; echo '...'; tail -n 15 "$log"; } >&2
  return 1
}

configure_project() {
  source_directory=$1
  build_directory=$2
  shift 2
  mkdir -p "$build_directory"
  build_log=$build_directory/build.log
  : >"$build_log"
  quietly "Configuring" "$build_log" cmake -S "$source_directory" -B "$build_directory" -G Ninja "$@"
}

build_target() {
  echo "Building $1 (log: $build_log) ..." >&2
  quietly "Building" "$build_log" cmake --build "$build_directory" -j "${MESOBRIDGE_JOBS:-2}" --target "$1"
}

# Sourced, not run: makes sure that every Debian package which the build needs is there.
# Installs what is missing as root or through sudo; otherwise says which command to run, and stops.

mesobridge_packages="cmake g++ ninja-build ccache pkg-config git
  liblammps-dev lammps-data libopenmpi-dev openmpi-bin libeigen3-dev libgsl-dev libhdf5-dev zlib1g-dev libboost-iostreams-dev libnlopt-dev libnlopt-cxx-dev
  libtomlplusplus-dev libcli11-dev libfmt-dev libspdlog-dev nlohmann-json3-dev libssl-dev gnuplot-nox
  libgtest-dev librapidcheck-dev libbenchmark-dev"

missing_packages() {
  for package in $mesobridge_packages; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || printf '%s ' "$package"
  done
}

# Runs a command quietly as root; its output is shown only when it fails.
as_root_quietly() {
  log=$(mktemp)
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@" >"$log" 2>&1 </dev/null && rm -f "$log" && return 0
  else
    sudo env DEBIAN_FRONTEND=noninteractive "$@" >"$log" 2>&1 && rm -f "$log" && return 0
  fi
  tail -n 20 "$log" >&2
  rm -f "$log"
  return 1
}

may_become_root() {
  [ "$(id -u)" -eq 0 ] && return 0
  command -v sudo >/dev/null 2>&1 || return 1
  sudo -n true 2>/dev/null && return 0
  [ -t 0 ] && [ -t 2 ] # somebody is there to type the password
}

install_packages() {
  if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "This is no Debian system: please install the counterparts of these packages: $mesobridge_packages" >&2
    return 0 # the build will tell what is missing
  fi
  missing=$(missing_packages)
  [ -z "$missing" ] && return 0
  if ! may_become_root; then
    echo "Some Debian packages are missing, and installing them needs root. Please run:" >&2
    echo "  apt-get update && apt-get install -y --no-install-recommends $missing" >&2
    return 1
  fi
  echo "Installing: $missing" >&2
  as_root_quietly apt-get update || { echo "apt-get update failed (see above)" >&2; return 1; }
  # One word a package is what is wanted here.
  # shellcheck disable=SC2086
  as_root_quietly apt-get install -y --no-install-recommends $missing ||
    { echo "apt-get install failed (see above)" >&2; return 1; }
}

#!/bin/sh
# Makes the runs of cases.txt with two builds of the program, the second on 1, 2 and 4 threads, and compares run.h5,
# checkpoint and trajectory bit for bit. For changes that are to change nothing:
#   sh tests/bits/run.sh OLD/build/mesobridge build/mesobridge [NAME ...]
# OLD may be the folder of an earlier call, which then serves again: its numbers are taken from there. A case that the old
# build cannot run is compared between the numbers of threads.
set -euf

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
old=$1 new=$2
shift 2
same=${new%/*}/same_numbers
short='particles.N=512 run.equilibrate=60 run.steps=120 run.sample_every=3 run.checkpoint_every=0 run.trajectory_every=40 profile.every=20'

run() { # program folder threads scene settings
  program=$1 folder=$2 threads=$3 scene=$4
  shift 4
  for setting in "$@"; do set -- "$@" --set "$setting"; shift; done # each word becomes two
  file=$here/$scene.toml
  [ -f "$file" ] || file=$here/../../workflows/scenes/$scene.toml
  "$program" run "$file" -o "$folder" --threads "$threads" --quiet --no-report "$@" \
    </dev/null >/dev/null 2>"$folder.log" && return 0
  [ $? -eq 3 ] && [ -f "$folder/run.h5" ] && return 0 # too short to be at equilibrium: its numbers are numbers
  echo "$folder: $(tail -n 1 "$folder.log")" >&2
  return 1
}

if [ -d "$old" ]; then work=$old; else work=$(mktemp -d); echo "Numbers of $old are kept in $work" >&2; fi
failed=0 passed=0
while read -r name scene settings; do
  case "$name" in '' | '#'*) continue ;; esac
  case " $* " in "  " | *" $name "*) ;; *) continue ;; esac
  # Words are settings; the stars of units are no patterns.
  # shellcheck disable=SC2086
  [ -d "$old" ] || run "$old" "$work/$name" 1 "$scene" $short $settings || rm -rf "${work:?}/$name"
  for threads in ${THREADS:-1 2 4}; do
    made=$work/$name-new
    rm -rf "$made"
    run "$new" "$made" $threads "$scene" $short $settings || { failed=$((failed + 1)); continue; }
    if [ ! -d "$work/$name" ]; then
      mv "$made" "$work/$name"
      echo "$name: not with the old build; $threads threads are the measure" >&2
      continue
    fi
    for file in run.h5 checkpoint.h5 trajectory.h5md; do
      [ -e "$work/$name/$file" ] && [ -e "$made/$file" ] || continue # earlier versions called the last one otherwise
      if "$same" "$work/$name/$file" "$made/$file"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    done
  done
  echo "$name" >&2
done <"$here/cases.txt"
echo "$passed files have the same numbers, $failed have not"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]

# What the cases share: runs that are whole, broken off by a limit on the size of files, and resumed.
PATH=$PWD/tools:$PATH # a stand-in for gnuplot, which would take longer than the runs
options="--quiet --threads 1 --set particles.N=343 --set run.steps=640"

whole() { $MESOBRIDGE run scene.toml -o whole $options || exit 7; }
broken() { # BLOCKS of 512 bytes, FOLDER
  (ulimit -f $1; $MESOBRIDGE run scene.toml -o $2 $options 2>broken.log)
  test $? = 4 || exit 7
}
resume() { $MESOBRIDGE run scene.toml -o $1 $options --resume; }
same() {
  for name in summary.json trajectory.xyz scene.toml; do cmp whole/$name $1/$name || return 1; done
}
overwrite() { printf 'damage' | dd of=$1 bs=1 seek=$2 conv=notrunc status=none; } # FILE, OFFSET

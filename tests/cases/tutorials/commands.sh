# Runs the commands of a tutorial, which are its indented lines, as its reader would.   sh commands.sh NAME
set -eu
mkdir bin && ln -s "$MESOBRIDGE" bin/mesobridge
PATH=$PWD/bin:$PATH
page=$SOURCE/workflows/tutorials/$1.md
sed -n 's/^    //p' "$page" >commands
echo "$(grep -c . commands) lines of commands"
set -x
. "./commands"

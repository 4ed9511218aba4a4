# Sourced: a screen for programs that draw, where there is none; it ends with the shell.
screen=$(mktemp -d)
Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp 3>"$screen/number" 2>"$screen/log" &
screen_process=$!
trap 'kill "$screen_process" 2>/dev/null; rm -r "$screen"' EXIT
until [ -s "$screen/number" ]; do # Xvfb writes its number when it is ready
  kill -0 "$screen_process" || { cat "$screen/log" >&2; exit 7; }
  sleep 0.1
done
DISPLAY=:$(cat "$screen/number")
export DISPLAY

# Sourced: a screen for programs that draw, where there is none; it ends with the shell.
screen=$(mktemp -d)
DISPLAY=:$((1000 + $$ % 50000)) # of this shell alone: two servers that choose at the same time choose the same
export DISPLAY
Xvfb "$DISPLAY" -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -noreset 3>"$screen/number" 2>"$screen/log" &
screen_process=$!
trap 'kill "$screen_process" 2>/dev/null; wait "$screen_process"; rm -r "$screen"' EXIT
until [ -s "$screen/number" ]; do # Xvfb writes its number when it is ready
  kill -0 "$screen_process" || { cat "$screen/log" >&2; exit 7; }
  sleep 0.1
done

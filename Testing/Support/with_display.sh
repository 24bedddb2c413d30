#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Runs a command with an X display of its own and ends with its status.
# usage: with_display.sh WIDTHxHEIGHT COMMAND [ARGUMENT...]
# The server itself takes the first number that is free, and one server starts or ends at a time. xvfb-run looks for a
# number before it starts the server, so that two that start at once can choose the same.
# Without -noreset a server begins anew when its last client closes, and refuses those who come meanwhile: ParaView
# closes its first window before it opens the next.
# A server that ends by itself, which was seen once in thousands of tests, is no fault of the command: what it said is
# shown, and the command runs once more.
set -euo pipefail

screen=${1}x24
shift
exec {turn}>"${TMPDIR:-/tmp}/surfacegeodesics-displays.lock"
log=$(mktemp)

start_server()
{
  flock "$turn"
  exec {numbers}< <(exec {turn}>&- Xvfb -displayfd 1 -screen 0 "$screen" -nolisten tcp -noreset 2>"$log")
  server=$!
  read -r -t 60 -u "$numbers" number ||
    { echo "with_display.sh: Xvfb has not started:" >&2; cat "$log" >&2; exit 1; }
  flock -u "$turn"
}

end_server()
{
  flock "$turn"
  kill "$server" 2>/dev/null || true
  wait "$server" 2>/dev/null || true
  flock -u "$turn"
}
trap 'end_server; rm -f "$log"' EXIT

start_server
status=0
DISPLAY=:$number "$@" || status=$?
if ((status != 0)) && ! kill -0 "$server" 2>/dev/null; then
  server_status=0
  wait "$server" || server_status=$?
  echo "with_display.sh: Xvfb ended by itself with $server_status, so the command runs once more. Xvfb said:" >&2
  cat "$log" >&2
  start_server
  status=0
  DISPLAY=:$number "$@" || status=$?
fi
exit "$status"

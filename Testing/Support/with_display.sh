#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Runs a command with an X display of its own and ends with its status.
# usage: with_display.sh WIDTHxHEIGHT COMMAND [ARGUMENT...]
# The server itself takes the first number that is free, and one server starts or ends at a time. xvfb-run looks for a
# number before it starts the server, so that two that start at once can choose the same.
# Without -noreset a server begins anew when its last client closes, and refuses those who come meanwhile: ParaView
# closes its first window before it opens the next.
# A program of ParaView without mpiexec lets Open MPI start a daemon, which fails once in a few hundred times where other
# programs start or end meanwhile; isolated, it needs none. Isolated programs have one folder in common, which the first
# to end removes while others begin; so each has one of its own.
set -euo pipefail

session=$(mktemp --directory)
export OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_orte_tmpdir_base=$session
exec {turn}>"${TMPDIR:-/tmp}/surfacegeodesics-displays.lock"
flock "$turn"
exec {numbers}< <(exec {turn}>&- Xvfb -displayfd 1 -screen 0 "${1}x24" -nolisten tcp -noreset 2>/dev/null)
server=$!

end_server()
{
  flock "$turn"
  kill "$server" 2>/dev/null || true
  wait "$server" 2>/dev/null || true
  rm -rf "$session"
}
trap end_server EXIT

read -r -t 60 -u "$numbers" number || { echo "with_display.sh: Xvfb has not started" >&2; exit 1; }
flock -u "$turn"
shift
status=0
DISPLAY=:$number "$@" || status=$?
exit "$status"

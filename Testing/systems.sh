#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Runs the README's two commands on the last commit of this checkout in a bare Debian 12 (ParaView 5.11), 13 (5.13) and
# sid (6.1), builds what needs no ParaView on the VTK (9.1, 9.3, 9.6) of another bare one, and prints a table of what came
# of them.
# usage: bash Testing/systems.sh [12|13|sid]...      (as root; without any, all three)
# Needs debootstrap, and about 8 GB of disk and an hour or two for each system. Everything is kept in the folder of the
# environment variable SYSTEMS, else /var/tmp/surfacegeodesics: what was downloaded and compiled for the next time, the
# last system as it was left, and the logs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder=${SYSTEMS:-/var/tmp/surfacegeodesics}
mirror=http://deb.debian.org/debian

suite_of()
{
  case $1 in
    12) echo bookworm ;;
    13) echo trixie ;;
    sid) echo sid ;;
    *) echo "Testing/systems.sh: $1 is no system; name 12, 13 or sid, or none for all" >&2; return 1 ;;
  esac
}

# make_bare SUITE
# The system as debootstrap makes it, once for all.
make_bare()
{
  local bare=$folder/$1.bare
  [[ ! -d $bare ]] || return 0
  rm -rf "$bare.part"
  debootstrap --variant=minbase "$1" "$bare.part" "$mirror"
  if [[ $1 == sid ]]; then
    # A mirror can be late.
    echo 'Acquire::Check-Valid-Until "false";' >"$bare.part/etc/apt/apt.conf.d/late-mirror"
  fi
  # Such a system is made again rather than mended after a crash.
  echo force-unsafe-io >"$bare.part/etc/dpkg/dpkg.cfg.d/unsafe-io"
  # What was downloaded is kept.
  rm -f "$bare.part/etc/apt/apt.conf.d/docker-clean"
  mv "$bare.part" "$bare"
}

# in_system ROOT COMMAND
# Its mounts are gone with it. It has the machine's /tmp: the numbers of X displays are taken there.
in_system()
{
  # shellcheck disable=SC2016
  unshare --mount --propagation private bash -euc '
    root=$1
    mount -t proc proc "$root/proc"
    mount --rbind /sys "$root/sys"
    mount --rbind /dev "$root/dev"
    mount --bind /tmp "$root/tmp"
    mount --bind "$2.archives" "$root/var/cache/apt/archives"
    mkdir -p "$root/root/.cache/ccache"
    mount --bind "$2.ccache" "$root/root/.cache/ccache"
    cp /etc/resolv.conf "$root/etc/resolv.conf"
    exec chroot "$root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
      CCACHE_NOHASHDIR=1 bash -c "cd /SurfaceGeodesics && $3"
  ' - "$1" "${1%.vtk}" "$2"
}

# make_root ROOT SUITE
# A bare system with this checkout.
make_root()
{
  rm -rf --one-file-system "${1:?}"
  cp -a --reflink=auto "$folder/$2.bare" "$1"
  git clone --quiet . "$1/SurfaceGeodesics"
}

# run_step SYSTEM STEP COMMAND [ROOT]
run_step()
{
  local log=$folder/$1.$2.log result=passed
  SECONDS=0
  echo "Debian $1: $3, see $log"
  in_system "${4:-$folder/$1}" "$3" </dev/null >"$log" 2>&1 || result=FAILED
  printf '%s in %d min' "$result" $(((SECONDS + 59) / 60)) >"$folder/$1.$2.result"
}

# How many tests of all passed, from ctest's closing lines.
count_of_tests()
{
  sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests failed out of \([0-9]*\)$/\1 of \2 failed/p' "$1" | tail -n 1
}

run_system()
{
  local system=$1 suite
  suite=$(suite_of "$system")
  make_bare "$suite"
  mkdir -p "$folder/$system.archives/partial" "$folder/$system.ccache"
  make_root "$folder/$system" "$suite"
  run_step "$system" demo 'bash Plugin/demo.sh'
  run_step "$system" tests 'bash Testing/run.sh'
  # Debian's ParaView 5.11 and 5.13 cannot be installed beside Debian's VTK.
  make_root "$folder/$system.vtk" "$suite"
  run_step "$system" vtk 'bash Testing/Install/vtk_alone.sh /opt/surfacegeodesics' "$folder/$system.vtk"
}

print_row()
{
  printf '| %-6s | %-9s | %-20s | %-20s | %-16s | %-20s |\n' "$@"
}

((EUID == 0)) || { echo "Testing/systems.sh: only root can make systems" >&2; exit 1; }
systems=("${@:-12}")
(($#)) || systems=(12 13 sid)
for system in "${systems[@]}"; do
  suite_of "$system" >/dev/null
done
mkdir -p "$folder"
for system in "${systems[@]}"; do
  run_system "$system"
done

echo
print_row Debian ParaView Plugin/demo.sh Testing/run.sh "the last tests" "VTK alone"
print_row ------ -------- -------------- -------------- -------------- ---------
failed=0
for system in "${systems[@]}"; do
  # shellcheck disable=SC2016
  version=$(chroot "$folder/$system" dpkg-query -W -f '${Version}' paraview 2>/dev/null) || version='?'
  print_row "$system" "${version%%+*}" "$(cat "$folder/$system.demo.result")" "$(cat "$folder/$system.tests.result")" \
    "$(count_of_tests "$folder/$system.tests.log")" "$(cat "$folder/$system.vtk.result")"
  ! grep -q FAILED "$folder/$system".{demo,tests,vtk}.result || failed=1
done
exit $failed

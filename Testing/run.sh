#!/usr/bin/env bash
# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
# Checks the sources, builds everything and runs the tests, from a bare Debian 12, 13 or sid.
# usage: bash Testing/run.sh [LABEL...]      (as root, or with sudo where packages are missing)
# Labels: core vtk tracing pvpython mpi gui install long. Without any, all tests are run but the long ones, more of mpi on
# four ranks.
#        bash Testing/run.sh bench [distances|paths|worst|exact|ranks|threads]
# Runs the benchmarks instead, for about half an hour, and writes benchmarks.md, path_benchmarks.md and
# worst_cases.md in Plugin/Documentation, exact_benchmarks.md with the table of guide/methods.md, and the tables of
# cluster_benchmarks.md and threads.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Plugin/packages.sh

build=build/dev
all_labels=(core vtk tracing pvpython mpi gui install)
labels=("${@:-${all_labels[@]}}")

fail()
{
  printf '%s\n' "Testing/run.sh: $1" "${@:2}" >&2
  exit 1
}

# The checks by these tools are made with one version of them, since each judges in its own way.
has_tool()
{
  command -v "$1" >/dev/null || { echo "Testing/run.sh: no $1 here, so its check is skipped."; return 1; }
}

check_format()
{
  has_tool clang-format-14 || return 0
  local file unformatted=()
  while read -r file; do
    clang-format-14 --dry-run --Werror "$file" 2>/dev/null || unformatted+=("$file")
  done < <(find . -path ./build -prune -o -name '*.h' -print -o -name '*.cxx' -print)
  ((${#unformatted[@]} == 0)) || fail "Not formatted, mend with clang-format-14 -i:" "${unformatted[@]}"
}

# Several sources at once, as this build unites them: each header is looked at once for all of them.
check_core_with_clang_tidy()
{
  has_tool clang-tidy-14 || return 0
  cmake --preset core-clang -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
  printf '%s\n' build/core-clang/Filters/Core/CMakeFiles/GeodesicsCore.dir/Unity/*.cxx |
    xargs -P "$(nproc)" -n 1 clang-tidy-14 -p build/core-clang --quiet --warnings-as-errors='*' \
      --checks=-bugprone-suspicious-include 2>&1 |
    sed '/ warnings\? generated\.$/d' ||
    fail "clang-tidy has complaints, see above"
}

check_includes()
{
  python3 Testing/Checks/includes.py . || fail "These includes point the wrong way; see Testing/Checks/includes.py"
}

# Runs a program of tests, spread over the processors, for ten minutes at most.
run_in_parts()
{
  local part parts=() failed=()
  for ((part = 0; part < $(nproc); ++part)); do
    GTEST_TOTAL_SHARDS=$(nproc) GTEST_SHARD_INDEX=$part timeout 600 "$@" --gtest_brief=1 &
    parts+=($!)
  done
  for part in "${parts[@]}"; do
    wait "$part" || failed+=("$part")
  done
  ((${#failed[@]} == 0)) || fail "Tests of $1 failed or took too long, see above"
}

# What is computed in another way without vector extensions.
test_scalar_core()
{
  cmake --preset core-scalar
  cmake --build --preset core-scalar --target ScalarTests
  run_in_parts build/core-scalar/bin/ScalarTests
}

# The core, what is read from outside, surfaces as nobody should make them, and the VTK classes: by Clang, under the
# address and undefined behaviour sanitizers. What takes long there can be run by hand: ctest --preset sanitized.
test_under_sanitizers()
{
  local labels='core|fuzz' targets=(CoreTests PromiseCampaign RequestFuzzer PointTextFuzzer) options=()
  if has_tool clang++-14; then
    labels+='|vtk'
    targets+=(VtkTests)
    options=(-DSURFACEGEODESICS_BUILD_VTK=ON "-DVTK_DIR=$(sed -n 's/^VTK_DIR:[A-Z]*=//p' "$build/CMakeCache.txt")")
  fi
  cmake --preset sanitized "${options[@]}"
  cmake --build --preset sanitized --target "${targets[@]}"
  ctest --preset sanitized --label-regex "^($labels)$" --parallel "$(nproc)" --output-on-failure \
    --exclude-regex "^($(paste --serial --delimiters='|' Testing/Checks/slow_when_sanitized.txt))\$"
}

# What works on several threads in the core, under the thread sanitizer.
test_threads()
{
  cmake --preset core-tsan
  cmake --build --preset core-tsan --target ThreadTests
  run_in_parts build/core-tsan/bin/ThreadTests --gtest_filter='*Thread*:Mailbox.*:SharedJobs.*:SharedSecondaryValues.*:*.ASearchGoesOver*'
}

check_labels()
{
  local label
  for label in "${labels[@]}"; do
    [[ $(ctest --test-dir "$build" -N -L "^$label$") == *"Total Tests: "[1-9]* ]] ||
      fail "No test has the label $label"
  done
}

install_packages build test
# Several builds compile the same sources with the same flags: once is enough, whatever language CTest sets, and
# whichever folder has the files that include several sources.
export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1 CCACHE_SLOPPINESS=locale
export CCACHE_BASEDIR="$PWD/build"
if [[ ${1-} == bench ]]; then
  case ${2-} in
    '') targets=(Benchmarks PathBenchmarks WorstCaseBenchmarks ExactBenchmarks RankBenchmarks ThreadBenchmarks) ;;
    distances) targets=(Benchmarks) ;;
    paths) targets=(PathBenchmarks) ;;
    worst) targets=(WorstCaseBenchmarks) ;;
    exact) targets=(ExactBenchmarks) ;;
    ranks) targets=(RankBenchmarks) ;;
    threads) targets=(ThreadBenchmarks) ;;
    *) fail "Benchmarks of $2 are not known: name distances, paths, worst, exact, ranks or threads, or none for all" ;;
  esac
  cmake --preset bench
  # One after the other: side by side they would disturb each other.
  for target in "${targets[@]}"; do
    cmake --build --preset bench --target "$target"
  done
  exit
fi
check_format
check_includes
check_core_with_clang_tidy
cmake --preset dev
cmake --build --preset dev
check_labels
if [[ " ${labels[*]} " == *" core "* ]]; then
  test_scalar_core
  test_under_sanitizers
  test_threads
fi
# Side by side but for those that ask for the whole machine: with several ranks, or with a real pointer.
run_tests=(ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)")
if (($#)); then
  "${run_tests[@]}" -L "^($(IFS='|'; echo "${labels[*]}"))$"
else
  "${run_tests[@]}" -LE '^long$'
fi

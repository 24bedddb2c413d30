# SPDX-FileCopyrightText: SurfaceGeodesics authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the document of the worst cases from their results.

usage: worst_report.py BUILD_FOLDER/benchmarks/worst.json DOCUMENT.md
"""

import json
import os
import string
import sys

import worst_cases
from report import number, output_of, processor, table

TEMPLATE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "worst_cases.md.in")
# Seconds of processor time that a case may take.
LIMIT = 60
# Seconds of processor time without a report of progress.
LONG_SILENCE = 0.2
ENDS = {"limit": f"more than {LIMIT} s", "error": "an error"}


def verdict(case, found):
    """Whether what is asked for holds; empty where nothing is."""
    if not case.asked:
        return ""
    if found["ended"] != "well":
        return "no"
    value = case.asked.of(found)
    if value <= case.asked.aim.value(found):
        return "yes, the aim"
    return "yes" if value <= case.asked.at_least.value(found) else "no"


def asked_of(case):
    return [case.asked.at_least.words, case.asked.aim.words] if case.asked else ["", ""]


def holds_cell(case, found):
    holds = verdict(case, found)
    return "**no**" if holds == "no" else holds


def duration(seconds):
    return f"{number(seconds)} s" if seconds >= 1 else f"{number(1e3 * seconds)} ms"


def figures(case, found):
    """Time, in times of one seed and of Dijkstra's algorithm, updates a point and silence."""
    if found["ended"] == "error":
        return [ENDS["error"], "", "", "", ""]
    seconds = found.get("seconds", LIMIT)

    def times(unit):
        more = "more than " if found["ended"] == "limit" else ""
        return more + number(seconds / found[unit]) if unit in found else ""

    if found["ended"] == "limit":
        return [ENDS["limit"], times("one_seed"), times("dijkstra"), "", ""]
    each = f" ({duration(seconds / found['items'])} a {case.each})" if case.each else ""
    return [duration(seconds) + each, times("one_seed"), times("dijkstra"),
            number(found["updates"]) if "updates" in found else "", duration(found["silence"])]


def table_of_times(cases, found):
    rows = []
    for case in cases:
        one = found[case.name]
        rows.append([case.name, f"{one['points']:,.0f}" if "points" in one else "", *figures(case, one),
                     *asked_of(case), holds_cell(case, one)])
    return table(["Case", "Points", "Time", "S", "D", "Updates a point", "Silence", "At least", "Aim", "Holds"],
                 rows)


def table_of_errors(cases, found):
    def percent(one, key):
        return f"{number(100 * one[key])} %" if key in one else ENDS[one["ended"]]

    return table(["Surface", "Points", "Too small at most", "before", "Mean error", "before", "At least", "Aim",
                  "Holds"],
                 [[case.name, f"{found[case.name].get('points', 0):,.0f}",
                   *(percent(found[case.name], key)
                     for key in ("too_small", "too_small_before", "mean_error", "mean_error_before")),
                   *asked_of(case), holds_cell(case, found[case.name])] for case in cases])


def differs_within(found, limits):
    return all(found[key] <= most for key, most in limits.items())


def verdict_on_difference(found):
    """Of a case that has a difference."""
    if differs_within(found, worst_cases.DIFFERENCE_AIM[1]):
        return "yes, the aim"
    return "yes" if differs_within(found, worst_cases.DIFFERENCE_AT_LEAST[1]) else "no"


def with_difference(found):
    return [(case, found[case.name]) for cases in worst_cases.TIMED.values() for case in cases
            if "difference_mean" in found[case.name]]


def table_of_differences(found):
    rows = []
    for case, one in with_difference(found):
        holds = verdict_on_difference(one)
        rows.append([case.name, number(one["difference_mean"]), number(one["difference_largest"]),
                     worst_cases.DIFFERENCE_AT_LEAST[0], worst_cases.DIFFERENCE_AIM[0],
                     "**no**" if holds == "no" else holds])
    return table(["Case", "Mean", "Largest", "At least", "Aim", "Holds"], rows)


def reason(found):
    if found["ended"] == "well":
        return ""
    return f" ({found.get('error', ENDS[found['ended']])})"


def shortfalls(found):
    """All that does not meet what is asked for, and what else does not end well, one a line."""
    groups = {**worst_cases.TIMED, "Errors": worst_cases.ERRORS}
    lines = [f"- Differences: {case.name}" for case, one in with_difference(found)
             if verdict_on_difference(one) == "no"]
    missed = len(lines)
    asked = len(with_difference(found))
    for group, cases in groups.items():
        for case in cases:
            asked += case.asked is not None
            if verdict(case, found[case.name]) == "no" or found[case.name]["ended"] != "well":
                lines.append(f"- {group}: {case.name}{reason(found[case.name])}")
    if not lines:
        return f"All {asked} rows with a target meet it."
    missed += sum(verdict(case, found[case.name]) == "no" for cases in groups.values() for case in cases)
    return "\n".join([f"{missed} of {asked} rows with a target do not meet it. These, and rows without a target "
                      "that do not end well:", "", *lines])


def silences(found):
    """The rows that can't be stopped soon."""
    names = [name for name, one in found.items() if one.get("silence", 0) > LONG_SILENCE]
    if not names:
        return "No row that ends is silent for longer."
    return "\n".join(["Silent for longer:", "", *(f"- {name} ({duration(found[name]['silence'])})" for name in names)])


def write(run, document):
    found = run["cases"]
    with open(TEMPLATE) as file:
        template = string.Template(file.read())
    text = template.substitute(
        limit=LIMIT,
        machine=f"{processor()}, {run['cores']} cores; g++ {output_of('g++', '-dumpfullversion')}; "
                f"commit {run['commit']}; "
                f"{run['date']}; load before the start {run['load'][0]:.2f}",
        shortfalls=shortfalls(found),
        long_silence=LONG_SILENCE,
        silences=silences(found),
        times="\n\n".join(f"## {group}\n\n{table_of_times(cases, found)}"
                          for group, cases in worst_cases.TIMED.items()),
        differences=table_of_differences(found),
        errors=table_of_errors(worst_cases.ERRORS, found))
    with open(document, "w") as file:
        file.write(text)


if __name__ == "__main__":
    with open(sys.argv[1]) as stream:
        write(json.load(stream), sys.argv[2])

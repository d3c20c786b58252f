#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures four strokes with ultrasound over mesh, step and method, and draws what they cost against how far they are from
# the finest: docs/data/phaco_chart.csv and docs/pictures/phaco_chart.svg. Needs a Release build (./demo.sh makes one) and
# the Debian package gnuplot-nox. It takes some minutes.
#   usage: scripts/dev/phaco_chart.sh [--draw]     --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
data=docs/data/phaco_chart.csv
picture=docs/pictures/phaco_chart.svg

need_gnuplot
if [ "${1:-}" != --draw ]; then
    bench_to_csv phaco "$data" name point elements cpu_s_per_s removed_error force_error depth_error failure
fi

series=(
    "explicit|20 ms|steps of 20 ms|#7a5195"
    "explicit|10 ms|10 ms (default)|#1b9e5a"
    "explicit|5 ms|5 ms|#4a90d9"
    "explicit|2 ms|2 ms|#e08214"
    "explicit, by vertices|10 ms|tools meet vertices, 10 ms|#c03030"
    "implicit, no chamber|10 ms|implicit, 10 ms, no chamber|#888888"
)
rows=$(mktemp -d)
trap 'rm -rf "$rows"' EXIT
number=0
for entry in "${series[@]}"; do
    IFS='|' read -r name point title colour <<<"$entry"
    number=$((number + 1))
    # a name with a comma in it is quoted
    python3 - "$data" "$name" "$point" >"$rows/$number" <<'END'
import csv
import sys

with open(sys.argv[1], encoding="utf-8") as file:
    for row in csv.DictReader(file):
        if row["name"] == sys.argv[2] and row["point"] == sys.argv[3] and not row["failure"]:
            errors = [row[key] and str(100 * float(row[key])) or "NaN" for key in ("removed_error", "force_error", "depth_error")]
            print(row["cpu_s_per_s"], *errors, row["elements"])
END
done

plots_of() {  # COLUMN
    local number=0 plots="" entry name point title colour
    for entry in "${series[@]}"; do
        IFS='|' read -r name point title colour <<<"$entry"
        number=$((number + 1))
        plots+="'$rows/$number' using 1:$1 with linespoints lc rgb '$colour' pt 7 ps 0.6 lw 2 title '$title', "
        plots+="'$rows/$number' using 1:$1:(sprintf('%.1fk', \$5/1000)) with labels offset 0.8,0.5 font ',8' tc rgb '$colour' notitle, "
    done
    printf '%s' "${plots%, }"
}

gnuplot <<END
set terminal svg size 860,1150 font "sans,12" background "white"
set output "$picture"
set multiplot layout 3,1
set logscale xy
set grid xtics ytics lc rgb "#dddddd"
set xrange [0.05:9]
set key above maxrows 2
set lmargin 11
set rmargin 4
set arrow from 1, graph 0 to 1, graph 1 nohead lc rgb "#c03030" lw 1.5
set title "four strokes with ultrasound, against 24,000 tetrahedra in steps of 1 ms; red: real time on one core"
set ylabel "volume removed at the end, % off"
plot $(plots_of 2)
unset title
unset key
set ylabel "force of the tip, rms, % of the greatest"
plot $(plots_of 3)
set xlabel "CPU seconds per simulated second (one thread); labels: thousands of tetrahedra"
set ylabel "depth of the chamber, rms % off"
plot $(plots_of 4)
unset multiplot
END
say "$data, $picture"

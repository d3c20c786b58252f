#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures the ways to advance the lens and draws speed against accuracy: docs/data/lens_chart.csv and
# docs/pictures/lens_chart.svg. Needs a Release build (./demo.sh makes one) and the Debian package gnuplot-nox. It takes
# some minutes.
#   usage: scripts/dev/lens_chart.sh [--draw]     --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
data=docs/data/lens_chart.csv
picture=docs/pictures/lens_chart.svg

need_gnuplot
if [ "${1:-}" != --draw ]; then
    bench_to_csv lens_chart "$data" name point elements cpu_s_per_s error failure
fi

series=(
    "explicit linear|0.8 of the limit|explicit, linear|#7a5195"
    "explicit nodal pressure|0.8 of the limit|explicit, pressure at nodes|#1b9e5a"
    "implicit linear|10 ms|implicit 10 ms, linear|#4a90d9"
    "implicit edge-smoothed|10 ms|implicit 10 ms, edge-smoothed|#e08214"
    "implicit edge-smoothed|1 ms|implicit 1 ms, edge-smoothed|#b0632a"
)
rows=$(mktemp -d)
trap 'rm -rf "$rows"' EXIT
plots=""
number=0
for entry in "${series[@]}"; do
    IFS='|' read -r name point title colour <<<"$entry"
    number=$((number + 1))
    awk -F, -v name="$name" -v point="$point" '$1 == name && $2 == point { print $4, 100 * $5, $3 }' "$data" >"$rows/$number"
    plots+="'$rows/$number' using 1:2 with linespoints lc rgb '$colour' pt 7 ps 0.7 lw 2 title '$title', "
    plots+="'$rows/$number' using 1:2:(sprintf('%.0fk', \$3/1000)) with labels offset 0.9,0.6 font ',9' tc rgb '$colour' notitle, "
done
# The original: 80 steps of 10 ms a second with a GPU, linear tetrahedra, about 3,000 of them
original=$(awk -F, '$1=="implicit linear" && $2=="10 ms" && $3>2900 && $3<3100 {print 100*$5}' "$data")

gnuplot <<END
set terminal svg size 860,600 font "sans,12" background "white"
set output "$picture"
set logscale xy
set xlabel "CPU seconds per simulated second (one thread)"
set ylabel "rms error of the depth under a tool, % of the final depth\nagainst quadratic tetrahedra (CalculiX C3D10) on the same mesh"
set key bottom left reverse Left opaque
set grid xtics ytics lc rgb "#dddddd"
set xrange [0.01:40]
set yrange [0.1:60]
set arrow from 1, graph 0 to 1, graph 1 nohead lc rgb "#c03030" lw 1.5
set arrow from 2, graph 0 to 2, graph 1 nohead lc rgb "#c03030" lw 1.5 dt 2
set label "real time, one core" at 0.93, 45 right tc rgb "#c03030" font ",10"
set label "two cores" at 2.1, 45 left tc rgb "#c03030" font ",10"
set arrow from 0.01, 15 to 40, 15 nohead lc rgb "#888888" dt 3
set label "15 %" at 0.0105, 17 tc rgb "#888888" font ",10"
set object circle at 1.25, $original size graph 0.008 fc rgb "black" fs solid
set label "original, with a GPU" at 1.4, $original left font ",10"
plot ${plots%, }
END
say "$data, $picture"

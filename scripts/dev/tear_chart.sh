#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures when a tear starts and where it goes, and draws the load at its start against the size of the triangles:
# docs/data/tear_load.csv, docs/data/tear_path.csv and docs/pictures/tear_chart.svg. Needs a Release build (./demo.sh makes
# one) and the Debian package gnuplot-nox. It takes two minutes.
#   usage: scripts/dev/tear_chart.sh [--draw]     --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
load=docs/data/tear_load.csv
path=docs/data/tear_path.csv
picture=docs/pictures/tear_chart.svg

need_gnuplot
if [ "${1:-}" != --draw ]; then
    bench_to_csv tear_load "$load" name elements edge_mm load_one_ring load_fixed_radius load_energy error
    bench_to_csv tear_path "$path" name elements angle_deg cpu_s_per_s error
fi

gnuplot <<END
set terminal svg size 860,420 font "sans,12" background "white"
set output "$picture"
set datafile separator ","
set multiplot layout 1,2
set logscale xy
set grid xtics ytics lc rgb "#dddddd"
set key top left
set xlabel "mean edge [mm]; crack 2 mm"
set ylabel "load at which the tear starts, over the finest"
set xrange [0.08:1]
plot "< grep -v slope $load" every ::1 using 3:4 with linespoints lc rgb "#c03030" pt 7 ps 0.7 lw 2 title "strength, triangles at the tip", \
     "< grep -v slope $load" every ::1 using 3:5 with linespoints lc rgb "#e08214" pt 7 ps 0.7 lw 2 title "strength, within 0.4 mm", \
     "< grep -v slope $load" every ::1 using 3:6 with linespoints lc rgb "#1b9e5a" pt 7 ps 0.7 lw 2 title "energy (default)"
set xlabel "CPU seconds per simulated second"
set ylabel "farthest from the mean path [edges]"
set xrange [0.02:3]
set yrange [0.02:2]
plot "< grep isotropic $path" using 4:5 with points lc rgb "#4a90d9" pt 7 ps 0.8 title "isotropic", \
     "< grep fibres $path" using 4:5 with points lc rgb "#7a5195" pt 5 ps 0.8 title "fibres, toughness 4 across"
unset multiplot
END
say "$load, $path, $picture"

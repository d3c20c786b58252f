#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures a needle that cuts the capsule and forceps that tear it, by mesh, step and solver, and draws error against
# cost: docs/data/capsule_chart.csv and docs/pictures/capsule_chart.svg. Needs a Release build (./demo.sh makes one) and
# the Debian package gnuplot-nox. It takes two minutes.
#   usage: scripts/dev/capsule_chart.sh [--draw]     --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
data=docs/data/capsule_chart.csv
picture=docs/pictures/capsule_chart.svg

need_gnuplot
if [ "${1:-}" != --draw ]; then
    bench_to_csv capsule_chart "$data" name elements edge_mm step_ms tolerance_un most_newton cpu_s_per_s \
        slowest_cpu_s_per_s path_mm torn_mm needle_mn pull_mn error failure
fi

gnuplot <<END
set terminal svg size 860,420 font "sans,12" background "white"
set output "$picture"
set datafile separator ","
set multiplot layout 1,2
set logscale xy
set grid xtics ytics lc rgb "#dddddd"
set key top right
set xlabel "CPU seconds per simulated second (one thread)"
set xrange [0.01:10]
set arrow 1 from 0.33, graph 0 to 0.33, graph 1 nohead lc rgb "#c03030"
set ylabel "force of the pull, % off the finest"
set yrange [0.1:100]
plot "< grep '^mesh,[0-9]' $data" using 7:(100*\$13) with points lc rgb "#1b9e5a" pt 7 ps 0.8 title "384 to 6,144 triangles, 10 ms", \
     "< grep '^step' $data" using 7:(100*\$13) with points lc rgb "#4a90d9" pt 5 ps 0.8 title "1,536 triangles, 2.5 to 40 ms", \
     "< grep -E '^(tolerance|most|kept)' $data" using 7:(100*\$13) with points lc rgb "#e08214" pt 9 ps 0.8 title "1,536 triangles, solvers"
set ylabel "path of the tear, edges off the finest"
set yrange [0.05:2]
plot "< grep '^mesh,[0-9]' $data" using 7:(\$9/\$3) with points lc rgb "#1b9e5a" pt 7 ps 0.8 notitle, \
     "< grep '^step' $data" using 7:(\$9/\$3) with points lc rgb "#4a90d9" pt 5 ps 0.8 notitle, \
     "< grep -E '^(tolerance|most|kept)' $data" using 7:(\$9/\$3) with points lc rgb "#e08214" pt 9 ps 0.8 notitle
unset multiplot
END
say "$data, $picture"

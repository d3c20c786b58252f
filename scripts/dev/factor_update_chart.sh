#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures what a split costs the linear solver by what becomes of its factor, and draws it against the number of splits
# that one factor serves: docs/data/factor_update.csv, docs/data/factor_update_6000.csv, docs/pictures/factor_update.svg.
# Needs a Release build (./demo.sh makes one) and the Debian package gnuplot-nox. It takes seven minutes.
#   usage: scripts/dev/factor_update_chart.sh [--draw]     --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
small=docs/data/factor_update.csv
large=docs/data/factor_update_6000.csv
picture=docs/pictures/factor_update.svg

need_gnuplot
if [ "${1:-}" != --draw ]; then
    fields=(scene elements method splits_per_factor cpu_ms ratio factor_ms solve_ms slowest_ms iterations refactored
        entries error changed_by_motion body_ms analysis_ms assembly_ms numbers_ms)
    bench_to_csv factor_update "$small" "${fields[@]}"
    bench_to_csv factor_update_6000 "$large" "${fields[@]}"
fi

# panel FILE SCENE TITLE
panel() {
    local kept
    kept=$(grep "^[0-9]*/$2,[0-9]*,stale,1," "$1" | cut -d, -f5)
    cat <<END
set title "$3"
plot $kept with lines lc rgb "#1b9e5a" lw 2 title "order kept, factored at each split (default)", \
     "< grep '^[0-9]*/$2,[0-9]*,anew,' $1" using 4:5 with points lc rgb "#222222" pt 5 ps 0.9 title "order and factor anew", \
     "< grep '^[0-9]*/$2,[0-9]*,updown,' $1" using 4:5 with linespoints lc rgb "#c03030" pt 7 ps 0.7 lw 2 title "updated and downdated", \
     "< grep '^[0-9]*/$2,[0-9]*,woodbury,' $1" using 4:5 with linespoints lc rgb "#7a5195" pt 7 ps 0.7 lw 2 title "dense correction (Woodbury)", \
     "< grep '^[0-9]*/$2,[0-9]*,stale,' $1" using 4:5 with linespoints lc rgb "#e08214" pt 7 ps 0.7 lw 2 title "earlier factor as it was"
END
}

gnuplot <<END
set terminal svg size 900,760 font "sans,12" background "white"
set output "$picture"
set datafile separator ","
set multiplot layout 2,2
set logscale xy
set grid xtics ytics lc rgb "#dddddd"
set key top left samplen 2 font "sans,10"
set xlabel "splits that a factor is meant to serve"
set ylabel "CPU ms per split"
set xrange [0.9:25]
set yrange [0.5:50]
$(panel "$small" lively "1,500 triangles, the sheet moves")
$(panel "$small" still "1,500 triangles, held still")
set yrange [2:800]
$(panel "$large" lively "6,000 triangles, the sheet moves")
$(panel "$large" still "6,000 triangles, held still")
unset multiplot
END
say "$small, $large, $picture"

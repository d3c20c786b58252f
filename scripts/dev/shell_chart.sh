#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures a shell with two plates, the discrete Kirchhoff triangle and the nine-term polynomial, and draws their errors
# against triangles and against the time of a Newton iteration: docs/data/shell_elements.csv,
# docs/pictures/shell_chart.svg. Needs a Release build (./demo.sh makes one) and the Debian package gnuplot-nox. It takes a
# minute.
#   usage: scripts/dev/shell_chart.sh [--draw]     --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
data=docs/data/shell_elements.csv
picture=docs/pictures/shell_chart.svg

need_gnuplot
if [ "${1:-}" != --draw ]; then
    bench_to_csv shell_elements "$data" problem element elements value reference signed_error cpu_ms error
fi

# panel PROBLEM TITLE COLUMN AXIS
panel() {
    cat <<END
set title "$2"
set xlabel "$4"
plot "< grep '^$1,dkt,' $data" using $3:(100*\$8) with linespoints lc rgb "#1b9e5a" pt 7 ps 0.7 lw 2 title "Kirchhoff (default)", \
     "< grep '^$1,nine_term,' $data" using $3:(100*\$8) with linespoints lc rgb "#c03030" pt 5 ps 0.7 lw 2 title "nine terms", \
     3 with lines lc rgb "#888888" dt 2 notitle
END
}

gnuplot <<END
set terminal svg size 1000,760 font "sans,12" background "white"
set output "$picture"
set datafile separator ","
set multiplot layout 2,3
set logscale xy
set grid xtics ytics lc rgb "#dddddd"
set key bottom left Left reverse samplen 1.5 font "sans,10"
set ylabel "error of the deflection [%]"
set yrange [0.02:60]
set rmargin 4
$(panel plate "clamped plate, central force" 3 triangles)
$(panel ring "slit ring, lifted" 3 triangles)
$(panel hemisphere "open hemisphere" 3 triangles)
$(panel plate "clamped plate, central force" 7 "CPU ms of a Newton iteration")
$(panel ring "slit ring, lifted" 7 "CPU ms of a Newton iteration")
$(panel hemisphere "open hemisphere" 7 "CPU ms of a Newton iteration")
unset multiplot
END
say "$data, $picture"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures ways to solve contact of a shell on a lifted cantilever and draws the error of its force against CPU time:
# docs/data/shell_contact_solvers.csv, docs/pictures/shell_contact_chart.svg. Needs a Release build (./demo.sh makes one)
# and the Debian package gnuplot-nox. It takes a minute.
#   usage: scripts/dev/shell_contact_chart.sh [--draw]     --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
data=docs/data/shell_contact_solvers.csv
picture=docs/pictures/shell_contact_chart.svg

need_gnuplot
if [ "${1:-}" != --draw ]; then
    bench_to_csv shell_contact_solvers "$data" method lift_mm us_per_contact us_per_step contacts deepest gate_error factors error
fi

# panel LIFT
panel() {
    cat <<END
set title "lifted by $1 mm of 10"
plot "< grep '^springs.*,$1,' $data" using 3:(100*\$9) with linespoints lc rgb "#1b9e5a" pt 7 ps 0.8 lw 2 title "springs, stiffness 1/4, 1, 4", \
     "< grep '^warped,$1,' $data" using 3:(100*\$9) with points lc rgb "#c03030" pt 5 ps 1.1 title "compliance warping", \
     "< grep '^warped_gate,$1,' $data" using 3:(100*\$9) with points lc rgb "#d08020" pt 9 ps 1.3 title "with its error gate", \
     "< grep '^true_compliance,$1,' $data" using 3:(100*\$9) with points lc rgb "#4060c0" pt 6 ps 1.5 title "true compliance"
END
}

gnuplot <<END
set terminal svg size 1000,380 font "sans,12" background "white"
set output "$picture"
set datafile separator ","
set multiplot layout 1,3
set logscale xy
set grid xtics ytics lc rgb "#dddddd"
set key top left Left reverse samplen 1.5 font "sans,10"
set xlabel "CPU us a step and contact"
set ylabel "error of the force [%]"
set xrange [50:10000]
set yrange [0.001:1000]
set rmargin 4
$(panel 0.1)
$(panel 1)
$(panel 3)
unset multiplot
END
say "$data, $picture"

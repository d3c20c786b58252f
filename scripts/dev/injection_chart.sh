#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures an implant pushed into its bag by springs of contact, and draws where it comes to lie and how deep it is pressed
# in against CPU time: docs/data/implant_bag_springs.csv, docs/pictures/injection_chart.svg. Needs a Release build
# (./demo.sh makes one) and the Debian package gnuplot-nox. It takes five minutes.
#   usage: scripts/dev/injection_chart.sh [--draw]     --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
data=docs/data/implant_bag_springs.csv
picture=docs/pictures/injection_chart.svg

need_gnuplot
if [ "${1:-}" != --draw ]; then
    bench_to_csv implant_bag_springs "$data" stiffer onset stick cpu_s_per_s deepest residual iterations_p50 iterations_p99 error
fi

# panel COLUMN FACTOR LABEL
panel() {
    cat <<END
set ylabel "$3"
plot "< awk -F, '\$1==20 && \$2==0.1' $data" using 4:(\$$1*$2) with linespoints lc rgb "#1b9e5a" pt 7 ps 0.8 lw 2 title "stiffening over 0.1, sticking 1 to 0.002", \
     "< awk -F, '\$1==20 && \$3==0.006' $data" using 4:(\$$1*$2) with points lc rgb "#1b9e5a" pt 6 ps 2 title "the kernel's", \
     "< awk -F, '\$1==80' $data" using 4:(\$$1*$2) with points lc rgb "#c03030" pt 5 ps 1.1 title "four times as stiff", \
     "< awk -F, '\$1==5' $data" using 4:(\$$1*$2) with points lc rgb "#4060c0" pt 9 ps 1.3 title "straight springs", \
     "< awk -F, '\$2==0.2 || \$2==0.05' $data" using 4:(\$$1*$2) with points lc rgb "#d08020" pt 11 ps 1.3 title "stiffening over 0.2, over 0.05"
END
}

gnuplot <<END
set terminal svg size 1000,400 font "sans,12" background "white"
set output "$picture"
set datafile separator ","
set multiplot layout 1,2
set logscale y
set grid xtics ytics lc rgb "#dddddd"
set key top right Right samplen 1.5 font "sans,10"
set xlabel "CPU s per simulated second"
set xrange [0:*]
set rmargin 4
set yrange [0.003:3]
$(panel 9 1 "nodes end elsewhere by, mean [mm]")
set yrange [1:100]
$(panel 5 100 "deepest penetration [% of the thickness]")
unset multiplot
END
say "$data, $picture"

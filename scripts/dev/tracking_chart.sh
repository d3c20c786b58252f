#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures what tracking reaches, prints the tables of docs/tracking.md, keeps their figures in docs/data/tracking_*.csv and
# draws accuracy against compute and errors with and without images: docs/pictures/tracking_chart.svg. Needs a Release build
# (./demo.sh makes one) and the Debian package gnuplot-nox. It takes an hour of CPU; one that was cut goes on where it was.
#   usage: scripts/dev/tracking_chart.sh [--draw] [OPTIONS of rhexis track measure]
#   --draw: only draw again what was measured before
set -euo pipefail
. "$(dirname "$0")/steps.sh"
cd "$repository"
data=docs/data
picture=docs/pictures/tracking_chart.svg
kept=build/tracking_figures

need_gnuplot
if [ "${1:-}" != --draw ]; then
    mkdir -p "$kept"
    measure=("${RHEXIS:-build/release/bindings/cli/rhexis}" track measure --first-seed 301 --seeds 5 --marker-seeds 10 --identities 1000000
        --keep "$kept/parts" "$@")
    "${measure[@]}" --json >"$kept/figures.json"
    python3 scripts/dev/tracking_csv.py "$kept/figures.json" "$data"
    "${measure[@]}" # the same parts as text
fi

chart() { printf '< grep "^.*%s.*,.,%s," %s/tracking_chart.csv' "$1" "$2" "$data"; }  # DETECTOR MARKERS
level() { printf '< grep "^.*%s.*,%s," %s/tracking_levels.csv' "$1" "$2" "$data"; }    # QUANTITY FROM

gnuplot <<END
set terminal svg size 1180,430 font "sans,12" background "white"
set output "$picture"
set datafile separator ","
set multiplot layout 1,3
set grid xtics ytics lc rgb "#dddddd"
set logscale xy
set key top right Right samplen 1 font "sans,10"
set xlabel "CPU ms for an exposure, one core"
set ylabel "tip, 95 % within [um]"
set xrange [0.1:40]
set yrange [10:3000]
set arrow from 0.1,40 to 40,40 nohead lc rgb "#c03030" lw 1.5
set label "goal" at 0.12,46 tc rgb "#c03030" font "sans,10"
set title "ways to detect; 6 to 2 cameras from right to left"
plot '$(chart "fitted outlines" 4)' using 4:7 with linespoints lc rgb "#1b9e5a" pt 7 ps 0.8 lw 2 title "fitted outlines (the kernel's)", \
     '$(chart "moments of the outline" 4)' using 4:7 with linespoints lc rgb "#4060c0" pt 5 ps 0.7 title "moments of the outline", \
     '$(chart "moments of light" 4)' using 4:7 with linespoints lc rgb "#7a5195" pt 9 ps 0.8 title "moments of light", \
     '$(chart "OpenCV contours, binary moments" 4)' using 4:7 with linespoints lc rgb "#d08020" pt 11 ps 0.8 title "OpenCV, contours", \
     '$(chart "OpenCV connected components" 4)' using 4:7 with linespoints lc rgb "#888888" pt 13 ps 0.8 title "OpenCV, connected components"
unset logscale
unset arrow
unset label
set xrange [0:*]
set yrange [0:*]
set xlabel "CPU ms for an exposure, one core"
set title "fitted outlines; labels: cameras"
plot '$(chart "fitted outlines" 4)' using 4:7 with linespoints lc rgb "#1b9e5a" pt 7 ps 0.8 lw 2 title "4 markers, 95 % within", \
     "" using 4:7:2 with labels offset 0.9,0.7 font "sans,10" tc rgb "#1b9e5a" notitle, \
     '$(chart "fitted outlines" 3)' using 4:7 with linespoints lc rgb "#d08020" pt 5 ps 0.8 lw 2 title "3 markers, 95 % within", \
     '$(chart "fitted outlines" 4)' using 4:6 with linespoints lc rgb "#1b9e5a" pt 6 ps 0.8 dt 2 title "4 markers, mean", \
     '$(chart "fitted outlines" 3)' using 4:6 with linespoints lc rgb "#d08020" pt 4 ps 0.8 dt 2 title "3 markers, mean"
set logscale y
set yrange [0.001:1]
set xrange [0:*]
set xlabel "tip by six cameras, off by [um]"
set ylabel "share that is farther off"
set title "the same clips with images and without"
plot '$(level "tip, six cameras" images)' using 5:(1-\$4) with steps lc rgb "#1b9e5a" lw 2 title "images", \
     '$(level "tip, six cameras" markers)' using 5:(1-\$4) with steps lc rgb "#d08020" lw 2 title "markers"
unset multiplot
END
say "$data/tracking_figures.csv, tracking_chart.csv, tracking_levels.csv; $picture"

// SPDX-License-Identifier: GPL-3.0-or-later
// A cantilever of 16 x 2 x 2 mm on no lattice. gmsh -3 -format msh41 cantilever.geo
SetFactory("Built-in"); lc = 0.6; Point(1)={0,0,0,lc}; Point(2)={0,2,0,lc}; Point(3)={0,2,2,lc}; Point(4)={0,0,2,lc};
Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1}; Curve Loop(1)={1,2,3,4}; Plane Surface(1)={1}; Extrude {16,0,0} { Surface{1}; }

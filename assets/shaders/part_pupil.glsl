// SPDX-License-Identifier: GPL-3.0-or-later
#define PART 2  // see microscope.frag

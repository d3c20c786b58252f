// SPDX-License-Identifier: GPL-3.0-or-later
#define PART 0  // see microscope.frag

// SPDX-License-Identifier: GPL-3.0-or-later
#define PART 6  // see microscope.frag

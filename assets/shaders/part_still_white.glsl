// SPDX-License-Identifier: GPL-3.0-or-later
#define PART 4  // see microscope.frag

// SPDX-License-Identifier: GPL-3.0-or-later
#define PART 1  // see microscope.frag

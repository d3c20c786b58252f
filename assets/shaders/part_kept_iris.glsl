// SPDX-License-Identifier: GPL-3.0-or-later
#define PART 7  // see microscope.frag

// SPDX-License-Identifier: GPL-3.0-or-later
#define PART 5  // see microscope.frag

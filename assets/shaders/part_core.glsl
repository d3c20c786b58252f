// SPDX-License-Identifier: GPL-3.0-or-later
#define PART 3  // see microscope.frag

// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/types.hpp"

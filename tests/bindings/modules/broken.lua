-- SPDX-License-Identifier: GPL-3.0-or-later
-- fails when it runs

error("broken on purpose")

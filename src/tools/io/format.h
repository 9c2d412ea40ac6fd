// SPDX-License-Identifier: GPL-3.0-or-later
// The former name of formats.h.
#pragma once

#include "formats.h"

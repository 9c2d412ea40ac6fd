// SPDX-License-Identifier: GPL-3.0-or-later
// The former name of codecs.h.
#pragma once

#include "codecs.h"

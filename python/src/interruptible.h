// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "filmsticking/reconstruct.h"

namespace filmsticking::python {

/// Runs `work` in a thread of its own, without the interpreter's lock. The calling thread, which holds it,
/// calls `progress(share, stage)` (None: nothing) with all that `work` reports, in order, and answers
/// signals: Python delivers them to its main thread only. If either raises, `work` is cancelled and awaited,
/// and the exception leaves.
Result interruptible(const std::function<Result(const Execution&)>& work, const pybind11::object& progress);

}  // namespace filmsticking::python

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "export.h"

namespace filmsticking {

/// How a reconstruction ended. Everything but `Ok` comes with an empty mesh.
enum class Status {
  Ok,                     ///< a closed, oriented 2-manifold was made
  TooFewPoints,           ///< fewer than four distinct finite points
  Coplanar,               ///< all points lie on one line or plane
  InvalidInput,           ///< no cloud, or one that cannot be read, or indices that are not in it
  InvalidOptions,         ///< an option is out of its range
  InvalidGuidingSurface,  ///< the given guiding surface is not a closed oriented 2-manifold
  NoSurface,              ///< no closed surface through the points was found
  TooComplex,             ///< the points' Delaunay triangulation is out of proportion to their number
  Cancelled,              ///< the caller asked to stop, or a function of the caller's threw
  OutOfMemory,            ///< an allocation failed, or more than Options::max_memory would be needed
  InternalError,          ///< a broken promise inside; please report it
};

/// One lower-case sentence without a full stop; never null.
FILMSTICKING_EXPORT const char* describe(Status status) noexcept;

}  // namespace filmsticking

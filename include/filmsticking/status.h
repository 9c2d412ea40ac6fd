// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "export.h"

namespace filmsticking {

/// How a reconstruction ended. The mesh is empty unless the status is Ok.
enum class Status {
  Ok,                     ///< the mesh keeps all guarantees of reconstruct()
  TooFewPoints,           ///< fewer than four distinct finite points
  Coplanar,               ///< all points lie on one line or plane
  InvalidInput,           ///< no cloud, an unreadable one, or indices outside it
  InvalidOptions,         ///< an option is out of its range
  InvalidGuidingSurface,  ///< the given guiding surface is not a closed oriented 2-manifold
  NoSurface,              ///< no closed surface through the points was found
  TooComplex,             ///< the Delaunay triangulation is too large for the number of points
  Cancelled,              ///< the caller asked to stop, or a callback threw
  OutOfMemory,            ///< an allocation failed, or Options::max_memory is too small
  InternalError,          ///< a bug; please report it
};

/// One lower-case sentence without a full stop; never null.
FILMSTICKING_EXPORT const char* describe(Status status) noexcept;

}  // namespace filmsticking

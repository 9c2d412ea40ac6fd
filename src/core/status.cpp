// SPDX-License-Identifier: GPL-3.0-or-later
#include "filmsticking/status.h"

namespace filmsticking {

const char* describe(Status status) noexcept {
  switch (status) {
    case Status::Ok:
      return "a closed surface was made";
    case Status::TooFewPoints:
      return "a closed surface needs at least four distinct finite points";
    case Status::Coplanar:
      return "all points lie on one plane, so they enclose no volume";
    case Status::InvalidInput:
      return "the input cloud or its indices cannot be used";
    case Status::InvalidOptions:
      return "an option is out of its range";
    case Status::InvalidGuidingSurface:
      return "the guiding surface given is not a closed oriented 2-manifold";
    case Status::NoSurface:
      return "no closed surface through the points was found";
    case Status::TooComplex:
      return "the points' Delaunay triangulation is far larger than that of any surface, as of points on two "
             "curves";
    case Status::Cancelled:
      return "the reconstruction was cancelled";
    case Status::OutOfMemory:
      return "not enough memory";
    case Status::InternalError:
      return "an internal check failed";
  }
  return "unknown status";
}

}  // namespace filmsticking

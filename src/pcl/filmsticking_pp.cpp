// SPDX-License-Identifier: GPL-3.0-or-later
#include <pcl/point_types.h>

#include <pcl/impl/instantiate.hpp>
#include <pcl/surface/impl/filmsticking_pp.hpp>

PCL_INSTANTIATE(FilmstickingPP, PCL_XYZ_POINT_TYPES)

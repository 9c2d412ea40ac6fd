// SPDX-License-Identifier: GPL-3.0-or-later
// Two files share the point types, so that two cores compile them.
#include <pcl/point_types.h>

#include <boost/preprocessor/seq/first_n.hpp>
#include <pcl/impl/instantiate.hpp>
#include <pcl/surface/impl/filmsticking_pp.hpp>

PCL_INSTANTIATE(FilmstickingPP, BOOST_PP_SEQ_FIRST_N(9, PCL_XYZ_POINT_TYPES))

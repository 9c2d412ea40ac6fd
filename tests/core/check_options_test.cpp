// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "failure.h"

namespace filmsticking {
namespace {

Status status_of(const Options& options) {
  try {
    check_options(options, 0);
  } catch (const Failure& failure) {
    EXPECT_FALSE(failure.message.empty());
    return failure.status;
  }
  return Status::Ok;
}

TEST(CheckOptions, TakesTheDefaultsAndThePaper) {
  EXPECT_EQ(status_of({}), Status::Ok);
  EXPECT_EQ(status_of(Options::paper()), Status::Ok);
}

TEST(CheckOptions, RefusesEveryNumberOutOfItsRange) {
  const std::function<void(Options&)> faults[] = {
      [](Options& o) { o.virtual_sites = -2; }, [](Options& o) { o.max_steps = 0; },
      [](Options& o) { o.max_rounds = -1; }, [](Options& o) { o.threads = -1; },
      [](Options& o) { o.max_memory = -1; }};
  for (const auto& fault : faults) {
    Options options;
    fault(options);
    EXPECT_EQ(status_of(options), Status::InvalidOptions);
  }
}

TEST(CheckOptions, NeedsAClosedManifoldOnlyWhereAFilmStartsFromIt) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  Options options;
  options.method = Method::Film;
  options.film_start = FilmStart::Given;
  EXPECT_EQ(status_of(options), Status::InvalidGuidingSurface);  // there is none
  const auto with = [&](const Mesh& surface) {
    options.guiding_surface = std::make_shared<Mesh>(surface);
    return status_of(options);
  };
  EXPECT_EQ(with(mesh), Status::Ok);
  Mesh fault = mesh;
  fault.triangles.pop_back();
  EXPECT_EQ(with(fault), Status::InvalidGuidingSurface);
  fault = mesh;
  fault.positions[2][1] = std::nan("");
  EXPECT_EQ(with(fault), Status::InvalidGuidingSurface);
  options.film_start = FilmStart::Sphere;
  EXPECT_EQ(status_of(options), Status::Ok);
  options.film_start = FilmStart::Given;
  options.method = Method::Labelling;
  EXPECT_EQ(status_of(options), Status::Ok);
}

}  // namespace
}  // namespace filmsticking

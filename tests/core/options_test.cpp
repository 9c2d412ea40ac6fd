// SPDX-License-Identifier: GPL-3.0-or-later
#include "filmsticking/options.h"

#include <gtest/gtest.h>

#include "filmsticking/reconstruct.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

TEST(Options, TheFormerNamesChooseWhatTheyChose) {
  Options options;
  EXPECT_EQ(method_of(options), Method::Labelling);
  options.initial_surface = InitialSurface::Sphere;
  EXPECT_EQ(method_of(options), Method::Film);
  EXPECT_EQ(film_start_of(options), FilmStart::Sphere);
  options.initial_surface = InitialSurface::Wrap;
  EXPECT_EQ(method_of(options), Method::Film);
  EXPECT_EQ(film_start_of(options), FilmStart::Wrap);
  options.initial_surface = InitialSurface::Given;
  EXPECT_EQ(method_of(options), Method::Film);
  EXPECT_EQ(film_start_of(options), FilmStart::Given);
  options.film_start = FilmStart::Wrap;
  options.initial_surface = InitialSurface::Carve;  // leaves the choice to the present names
  EXPECT_EQ(method_of(options), Method::Labelling);
  EXPECT_EQ(film_start_of(options), FilmStart::Wrap);
}

TEST(Options, TheFormerNamesGiveTheSameMeshes) {
  const std::vector<Point> points = test::torus(600, 1);
  const auto mesh = [&](Options options) {
    options.max_steps = 6;
    options.max_rounds = 1;
    return reconstruct(points, options).triangles;
  };
  Options former, present;
  present.method = Method::Film;
  for (const auto& [old, start] : {std::pair(InitialSurface::Sphere, FilmStart::Sphere),
                                   std::pair(InitialSurface::Wrap, FilmStart::Wrap)}) {
    former.initial_surface = old;
    present.film_start = start;
    const std::vector<Triangle> triangles = mesh(present);
    EXPECT_FALSE(triangles.empty());
    EXPECT_EQ(mesh(former), triangles);
  }
}

TEST(Options, ThePaperIsAFilmFromTheSphereWithOnePoissonRound) {
  const Options paper = Options::paper();
  EXPECT_EQ(method_of(paper), Method::Film);
  EXPECT_EQ(film_start_of(paper), FilmStart::Sphere);
  EXPECT_EQ(paper.field, FieldMethod::Poisson);
  EXPECT_EQ(paper.ring, RingChoice::Smooth);
  EXPECT_EQ(paper.virtual_sites, 1000);
  EXPECT_EQ(paper.max_rounds, 1);
  EXPECT_TRUE(paper.weights);
  EXPECT_TRUE(paper.sharp_edges);
}

TEST(Options, RdHasNeitherWeightsNorVirtualSitesAndSculpts) {
  const Options rd = Options::rd();
  EXPECT_EQ(method_of(rd), Method::Film);
  EXPECT_EQ(rd.field, FieldMethod::Sculpt);
  EXPECT_EQ(rd.ring, RingChoice::Nearest);
  EXPECT_EQ(rd.virtual_sites, 0);
  EXPECT_FALSE(rd.weights);
  EXPECT_GT(rd.max_rounds, 1);
}

}  // namespace
}  // namespace filmsticking

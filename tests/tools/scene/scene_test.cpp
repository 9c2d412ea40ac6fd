// SPDX-License-Identifier: GPL-3.0-or-later
// What mesh_view and mesh_snapshot share, without a display.
#include <gif_lib.h>
#include <gtest/gtest.h>
#include <vtkNew.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "io/formats.h"
#include "io/io_error.h"
#include "report/scale_length.h"
#include "scene/camera.h"
#include "scene/deviation.h"
#include "scene/drawing.h"
#include "scene/image.h"
#include "scene/steps.h"
#include "support/clouds.h"
#include "support/model.h"
#include "support/scratch_folder.h"

namespace filmsticking::test {
namespace {

using scene::Frame;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Two triangles, the square from 0 to `side` at height z, seen from above.
Model square(double side, double z) {
  return {{{0, 0, z}, {side, 0, z}, {side, side, z}, {0, side, z}}, {}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(Camera, FramesAreRightHandedAndUpright) {
  for (const bool z_up : {false, true})
    for (const double azimuth : {0., 30., 200.})
      for (const double elevation : {-90., -20., 0., 45.}) {
        const Frame frame = scene::make_frame({azimuth, elevation, z_up});
        const Point &r = frame.right, &u = frame.up, &o = frame.out;
        EXPECT_NEAR(dot(r, r), 1, 1e-12);
        EXPECT_NEAR(dot(r, u), 0, 1e-12);
        const Point cross{r[1] * u[2] - r[2] * u[1], r[2] * u[0] - r[0] * u[2], r[0] * u[1] - r[1] * u[0]};
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(cross[k], o[k], 1e-12);
        const int axis = z_up ? 2 : 1;
        EXPECT_NEAR(r[axis], 0, 1e-12);
        EXPECT_GE(u[axis], -1e-12);
        EXPECT_NEAR(o[axis], std::sin(elevation * M_PI / 180), 1e-12);
      }
}

TEST(Camera, AimsTightlyAndLeavesOutWhatIsNotFinite) {
  std::vector<Point> points = sphere(500, 3, {1e6, -5, 7}, 2);
  points.push_back({kNan, 0, 0});
  points.push_back({0, -std::numeric_limits<double>::infinity(), 0});
  const std::vector<Frame> one{scene::make_frame({30, 20, false})};
  const scene::Target still = scene::aim({points}, one);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(still.half_size[k], 2, 0.05);
    EXPECT_LT(still.half_size[k], 2);
  }
  EXPECT_NEAR(still.middle[0], 1e6, 0.1);

  // Of a turn, every view holds every point, and the middle is one for all.
  std::vector<Point> rod{{0, 0, 0}, {10, 1, 0}, {4, 0.5, 2}};
  std::vector<Frame> turn;
  for (int i = 0; i < 8; ++i) turn.push_back(scene::make_frame({45.0 * i, 20, false}));
  const scene::Target target = scene::aim({rod}, turn);
  for (const Frame& frame : turn)
    for (Point p : rod) {
      for (int k = 0; k < 3; ++k) p[k] -= target.middle[k];
      EXPECT_LE(std::abs(dot(p, frame.right)), target.half_size[0]);
      EXPECT_LE(std::abs(dot(p, frame.up)), target.half_size[1]);
      EXPECT_LE(std::abs(dot(p, frame.out)), target.half_size[2]);
    }
  EXPECT_LT(target.half_size[0], 6);
  EXPECT_EQ(scene::aim({}, one).half_size[0], 0.5);
}

TEST(Deviation, IsTheDistanceToTheReference) {
  const Model reference = square(4, 0);
  const scene::Deviation deviation(reference);
  const std::vector<double> points =
      deviation.of_points({{1, 1, 0.5}, {2, 2, -3}, {7, 8, 0}, {kNan, 0, 0}, {4, 4, 0}});
  EXPECT_NEAR(points[0], 0.5, 1e-12);
  EXPECT_NEAR(points[1], 3, 1e-12);
  EXPECT_NEAR(points[2], 5, 1e-12);  // 3, 4, 5 past the corner
  EXPECT_TRUE(std::isnan(points[3]));
  EXPECT_NEAR(points[4], 0, 1e-12);
}

TEST(Deviation, OfAFaceIsTheLargestOfCornersAndMiddle) {
  // The base of a roof has its corners on it and its middles away from it.
  Model roof{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}}, {}, {}};
  roof.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  Model base = square(2, 0);
  base.positions.push_back({1, 1, 7});
  base.positions.push_back({kNan, 1, 1});
  base.triangles.push_back({0, 1, 4});
  base.triangles.push_back({0, 1, 5});
  const std::vector<double> faces = scene::Deviation(roof).of_faces(base);
  ASSERT_EQ(faces.size(), 4u);
  // The middle of a bottom face, (4/3, 2/3, 0), is 2/3 from two sides, which rise by 3 in 1.
  EXPECT_NEAR(faces[0], (2.0 / 3) * 3 / std::sqrt(10), 1e-9);
  EXPECT_NEAR(faces[2], 4, 1e-9);  // its tip over the roof's
  EXPECT_TRUE(std::isnan(faces[3]));
}

TEST(Deviation, KeepsItsDigitsFarOut) {
  Model near = square(1, 0), far = near;
  for (Point& p : far.positions) p = {p[0] + 4e6, p[1] + 5e6, p[2]};
  EXPECT_NEAR(scene::Deviation(far).of_points({{4e6 + 0.5, 5e6 + 0.5, 1e-3}})[0], 1e-3, 1e-9);
}

TEST(Deviation, RefusesAReferenceWithoutFiniteFaces) {
  Model broken = square(1, kNan);
  EXPECT_THROW(scene::Deviation{broken}, io::IoError);
  EXPECT_THROW(scene::Deviation{Model{}}, io::IoError);
}

TEST(ScaleLength, IsRoundAndForgetsStrays) {
  EXPECT_DOUBLE_EQ(mesh_report::scale_length({0, 0.31, 0.2}), 0.5);
  EXPECT_DOUBLE_EQ(mesh_report::scale_length({0.6}), 1);
  EXPECT_DOUBLE_EQ(mesh_report::scale_length({20}), 20);
  EXPECT_NEAR(mesh_report::scale_length({1.3e-7}), 2e-7, 1e-20);
  std::vector<double> mostly(1000, 0.15);
  mostly[7] = 90;
  mostly[8] = kNan;
  EXPECT_NEAR(mesh_report::scale_length(mostly), 0.2, 1e-15);
  for (const std::vector<double>& none : {std::vector<double>{}, {0., 0.}, {kNan}})
    EXPECT_EQ(mesh_report::scale_length(none), 1);
}

TEST(ColourTable, GoesFromPaleToBlueWithoutRed) {
  const auto table = scene::make_colour_table(0.2);
  double pale[3], end[3], beyond[3], none[3];
  table->GetColor(0, pale);
  table->GetColor(0.2, end);
  table->GetColor(5, beyond);
  table->GetColor(kNan, none);
  EXPECT_GT(std::min(pale[0], pale[1]), 0.95);
  EXPECT_LT(end[0], 0.2);
  EXPECT_GT(end[2], 0.5);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(end[k], beyond[k]);
  EXPECT_EQ(none[0], none[2]);
  double last = 3;
  for (double value = 0; value <= 0.2; value += 0.01) {
    double c[3];
    table->GetColor(value, c);
    const double sum = c[0] + c[1] + c[2];
    EXPECT_LE(sum, last + 1e-9);  // always darker
    EXPECT_FALSE(c[0] > c[1] + 0.1);
    last = sum;
  }
}

TEST(Steps, ComeInTheirOrderAndNameWhatIsBroken) {
  const ScratchFolder folder;
  EXPECT_THROW(scene::read_steps(folder / "missing"), io::IoError);
  EXPECT_THROW(scene::read_steps(folder.path().string()), io::IoError);
  for (const char* name : {"step_010.ply", "step_1000.ply", "step_002.ply", "other.ply"})
    io::write_mesh(folder / name, square(1, name[6] - '0'));
  const std::vector<scene::Step> steps = scene::read_steps(folder.path().string());
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[0].name, "step_002.ply");
  EXPECT_EQ(steps[1].name, "step_010.ply");
  EXPECT_EQ(steps[2].name, "step_1000.ply");
  EXPECT_EQ(steps[0].film.polygons.size(), 2u);
  std::ofstream(folder / "step_003.ply") << "ply\n";
  try {
    scene::read_steps(folder.path().string());
    FAIL();
  } catch (const io::IoError& error) {
    EXPECT_NE(std::string(error.what()).find("step_003.ply: "), std::string::npos) << error.what();
  }
}

/// A picture of two colours: `left` up to `column`, and a white rest, with one black pixel at the top left.
vtkSmartPointer<vtkImageData> picture(int width, int height, int column, const io::Colour& left) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int k = 0; k < 3; ++k)
        static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0))[k] = x < column ? left[k] : 255;
  std::memset(image->GetScalarPointer(0, height - 1, 0), 0, 3);
  return image;
}

TEST(Gif, DecodesToThePicturesThatWentIn) {
  struct Source {
    std::string bytes;
    std::size_t next = 0;
  } source;
  source.bytes = scene::encode_gif({picture(31, 17, 5, {200, 30, 40}), picture(31, 17, 20, {200, 30, 40}),
                                    picture(31, 17, 9, {10, 90, 220})},
                                   10);
  int error = 0;
  GifFileType* gif = DGifOpen(
      &source,
      [](GifFileType* file, GifByteType* to, int count) {
        auto* from = static_cast<Source*>(file->UserData);
        const std::size_t n = std::min<std::size_t>(count, from->bytes.size() - from->next);
        std::memcpy(to, from->bytes.data() + from->next, n);
        from->next += n;
        return static_cast<int>(n);
      },
      &error);
  ASSERT_NE(gif, nullptr) << GifErrorString(error);
  ASSERT_EQ(DGifSlurp(gif), GIF_OK);
  EXPECT_EQ(source.next, source.bytes.size());
  EXPECT_EQ(gif->SWidth, 31);
  EXPECT_EQ(gif->SHeight, 17);
  ASSERT_EQ(gif->ImageCount, 3);
  EXPECT_NE(source.bytes.find("NETSCAPE2.0"), std::string::npos);
  const int columns[] = {5, 20, 9};
  const int colours[][3] = {{200, 30, 40}, {200, 30, 40}, {10, 90, 220}};
  for (int i = 0; i < 3; ++i) {
    GraphicsControlBlock control;
    ASSERT_EQ(DGifSavedExtensionToGCB(gif, i, &control), GIF_OK);
    EXPECT_EQ(control.DelayTime, 10);
    const GifByteType* raster = gif->SavedImages[i].RasterBits;
    for (int y = 0; y < 17; ++y)
      for (int x = 0; x < 31; ++x) {
        const GifColorType& is = gif->SColorMap->Colors[raster[31 * y + x]];
        const bool corner = x == 0 && y == 0;  // the first row is the upper one
        const int should[] = {corner           ? 0
                              : x < columns[i] ? colours[i][0]
                                               : 255,
                              corner           ? 0
                              : x < columns[i] ? colours[i][1]
                                               : 255,
                              corner           ? 0
                              : x < columns[i] ? colours[i][2]
                                               : 255};
        EXPECT_NEAR(is.Red, should[0], 2) << x << ' ' << y << " of " << i;
        EXPECT_NEAR(is.Green, should[1], 2);
        EXPECT_NEAR(is.Blue, should[2], 2);
      }
  }
  DGifCloseFile(gif, nullptr);
}

}  // namespace
}  // namespace filmsticking::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that programs drew, judged by their pixels.
#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "support/model.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

namespace filmsticking::test {

/// A cube; `hole` leaves one side out, `inside_out` turns its faces.
inline Model cube(bool hole, bool inside_out) {
  Model model;
  for (int i = 0; i < 8; ++i)
    model.positions.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  model.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {2, 6, 7}, {2, 7, 3}};
  if (hole) model.triangles.resize(10);
  if (inside_out)
    for (Triangle& t : model.triangles) std::swap(t[1], t[2]);
  return model;
}

/// Runs a program on a display of its own.
inline Outcome run_on_display(const std::string& xvfb_run, const std::string& program,
                              const std::vector<std::string>& arguments) {
  // A file of ours for the display's key: xvfb-run may fail to take its own away, and then fails itself.
  const ScratchFolder folder;
  std::ofstream(folder / "key").flush();
  std::vector<std::string> command = {xvfb_run, "-a", "-f", folder / "key", program};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_program(command);
}

/// The shares of a part of a picture.
struct Pixels {
  int width = 0, height = 0;
  double white = 0, red = 0, grey = 0, blue = 0, violet = 0;
};

/// The upper row first.
struct Picture {
  int width = 0, height = 0;
  std::vector<io::Colour> pixels;
};

inline Picture read_picture(const std::string& path) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  Picture picture{image->GetDimensions()[0], image->GetDimensions()[1], {}};
  for (int y = picture.height - 1; y >= 0; --y)
    for (int x = 0; x < picture.width; ++x) {
      const auto* rgb = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
      picture.pixels.push_back({rgb[0], rgb[1], rgb[2]});
    }
  return picture;
}

/// Counts the columns of pixels from `begin` to `end`, both as shares of the width.
inline Pixels count_pixels(const Picture& picture, double begin = 0, double end = 1) {
  Pixels pixels;
  pixels.width = picture.width;
  pixels.height = picture.height;
  double count = 0;
  for (int x = static_cast<int>(begin * pixels.width); x < static_cast<int>(end * pixels.width); ++x)
    for (int y = 0; y < pixels.height; ++y) {
      const auto [r, g, b] = picture.pixels[static_cast<std::size_t>(y) * picture.width + x];
      ++count;
      if (std::min({r, g, b}) > 250) {
        ++pixels.white;
      } else if (r > 2 * g + 20 && r > 2 * b + 20) {
        ++pixels.red;
      } else if (b > g + 60 && r > g + 60) {
        ++pixels.violet;
      } else if (b > r + 60) {
        ++pixels.blue;
      } else {
        ++pixels.grey;
      }
    }
  for (double* share : {&pixels.white, &pixels.red, &pixels.grey, &pixels.blue, &pixels.violet})
    *share /= count;
  return pixels;
}

inline Pixels read_pixels(const std::string& path, double begin = 0, double end = 1) {
  return count_pixels(read_picture(path), begin, end);
}

}  // namespace filmsticking::test

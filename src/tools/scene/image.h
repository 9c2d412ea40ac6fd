// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace filmsticking::scene {

/// A connection to the X display. While there is one, windows can be opened: VTK would end the program where
/// no display can be reached, and Xvfb starts anew, deaf for a moment, when its last client leaves.
class DisplayConnection {
 public:
  /// Throws io::IoError.
  DisplayConnection();
  ~DisplayConnection();
  DisplayConnection(const DisplayConnection&) = delete;
  DisplayConnection& operator=(const DisplayConnection&) = delete;

 private:
  void* display_;
};

/// What the window shows, in red, green and blue. A copy: the next picture leaves it alone.
vtkSmartPointer<vtkImageData> grab(vtkRenderWindow* window);

/// The bytes of a PNG file.
std::string encode_png(vtkImageData* image);

/// The bytes of an animated GIF file that repeats for ever, with 256 colours for all pictures together. They
/// have one size, up to 65535 a side. Throws io::IoError.
std::string encode_gif(const std::vector<vtkSmartPointer<vtkImageData>>& pictures,
                       double pictures_per_second);

}  // namespace filmsticking::scene

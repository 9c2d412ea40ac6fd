// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace filmsticking::scene {

/// A connection to the X display, to be held while windows are open. VTK ends the program where it reaches no
/// display, and Xvfb restarts, and refuses clients for a moment, when its last client leaves.
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

/// A copy of the picture in the window, in red, green and blue.
vtkSmartPointer<vtkImageData> grab(vtkRenderWindow* window);

/// The bytes of a PNG file.
std::string encode_png(vtkImageData* image);

/// The bytes of an animated GIF file that repeats without end, with 256 colours for all pictures together.
/// The pictures have one size, up to 65535 a side. Throws io::IoError.
std::string encode_gif(const std::vector<vtkSmartPointer<vtkImageData>>& pictures,
                       double pictures_per_second);

}  // namespace filmsticking::scene
